"""Prints how long each test of a run took, and which were skipped: longest.py RESULTS.xml, as ctest --output-junit writes them."""
import sys
import xml.etree.ElementTree

for case in xml.etree.ElementTree.parse(sys.argv[1]).getroot().iter("testcase"):
    skipped = ", skipped" if case.find("skipped") is not None else ""
    print(f"{float(case.get('time')):6.0f} s  {case.get('name')}{skipped}")
