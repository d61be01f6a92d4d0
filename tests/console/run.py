#!/usr/bin/env python3
"""Types what transcripts type, and shows where gjkstep answers otherwise than they say.

    run.py PROGRAM [FILE...] [--accept]

Without a FILE all transcripts beside this script are run, and README.md of the project. --accept writes into the files what is
answered now: look at the difference before you commit it. A transcript is made of blocks, each run in an empty folder:

    # What the block shows; "[needs egl]" at its end: left out by --without egl.
    $ a command for sh; gjkstep is PROGRAM, and what bin/ beside this script holds can be called
    > more lines of the command
    | lines of its standard input
    its standard output
    2> its standard error
    = 2

The last line is the exit code, where that is not 0. Of what is answered, … stands for what varies in a line, as the folder's
path, and a line of … for one line or more; ␄ follows a last line that does not end. Blank lines before # are for the eye.

In Markdown what stands between ``` and begins with $ is run, in one folder, which readme.sh beside this script has filled. It
shows output and errors together. Where it shows nothing the exit code is 0 and anything may be said.
"""

import argparse
import concurrent.futures
import difflib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parent.parent
MARK = re.compile(r'(#|\$|>|\||2>|=)( |$)?')
ORDER = ('$', '>', '|', '', '2>', '=')
NEEDS = ('egl', 'ffmpeg', 'live', 'osmesa', 'ulimit')


class Refused(Exception):
    """What cannot be understood, and would else pass without being looked at."""


class Command:
    def __init__(self, text, number):
        self.text, self.input, self.number = text, '', number
        self.begin = self.end = number  # of the lines that answer


def check(is_right, number, reason):
    if not is_right:
        raise Refused(f'{number}: {reason}')


def transcript(lines, without):
    """Returns: the commands of each block, none where it is left out."""
    blocks, before = [], '#'
    for number, line in enumerate(lines, 1):
        if line == '' and (number == len(lines) or lines[number].startswith('# ')):
            before = ''
            continue
        mark = MARK.match(line)
        check(not mark or mark[2] is not None, number, 'a mark has a blank behind it, and no output begins like one')
        kind, rest = (mark[1], line[mark.end():]) if mark else ('', line)
        if kind == '#':
            needed = re.search(r'\[needs (.*)\]$', rest)
            check(not needed or needed[1] in NEEDS, number, f'needed may be {", ".join(NEEDS)}')
            if before != '#' or not blocks:
                check(not blocks or blocks[-1][1], number, 'the block before has no command')
                blocks.append((True, []))
            if needed and needed[1] in without:
                blocks[-1] = (False, blocks[-1][1])
        elif kind == '$':
            check(blocks, number, 'a block begins with # and what it shows')
            blocks[-1][1].append(Command(rest, number))
        else:
            check(blocks and blocks[-1][1], number, 'this follows no command')
            check(ORDER.index(kind) >= ORDER.index(before) and before != '=', number, f'the order is {" ".join(ORDER)}')
            check(kind != '=' or re.fullmatch('[1-9][0-9]*', rest), number, 'an exit code is a number other than 0')
            command = blocks[-1][1][-1]
            command.text += '\n' + rest if kind == '>' else ''
            command.input += rest + '\n' if kind == '|' else ''
            command.begin = number if kind in ('>', '|') else command.begin
            command.end = number
        before = kind
    check(blocks and blocks[-1][1], len(lines), 'there is no command at the end')
    return [commands if is_wanted else [] for is_wanted, commands in blocks]


def markdown(lines, _):
    """Returns: the commands that a text shows, as one block."""
    commands, is_inside, is_session = [], False, False
    for number, line in enumerate(lines, 1):
        if line.startswith('```'):
            is_inside = not is_inside
            is_session = is_inside and line == '```' and (lines + [''])[number].startswith('$ ')
        elif is_session and line.startswith('$ '):
            commands.append(Command(line[2:], number))
        elif is_session:
            commands[-1].end = number
    check(commands, len(lines), 'no command is shown')
    return [commands]


def covers(expected, actual):
    """Returns: whether the actual lines are the expected ones, as far as these say."""
    def pattern(line):
        return r'(?:(?!2> |= ).*\n)+?' if line == '…' else '.+'.join(map(re.escape, line.split('…'))) + r'\n'
    return re.fullmatch(''.join(map(pattern, expected)), ''.join(line + '\n' for line in actual)) is not None


def merged(expected, actual):
    """Returns: the actual lines, but for expected ones that cover theirs."""
    if covers(expected, actual):
        return expected
    changes = difflib.SequenceMatcher(None, expected, actual, autojunk=False).get_opcodes()
    return [line for _, i, j, k, l in changes
            for line in (expected[i:j] if covers(expected[i:j], actual[k:l]) else actual[k:l])]


def lines_of(output, folder):
    text = output.decode('utf-8', 'surrogateescape').replace(folder, '…')
    return (text if text.endswith('\n') or not text else text + '␄\n').split('\n')[:-1]


class Runner:
    def __init__(self, program, folder):
        self.folder = folder
        for name in ('bin', 'home'):
            (folder / name).mkdir()
        for name, target in (('gjkstep', program), ('python3', sys.executable)):
            (folder / 'bin' / name).symlink_to(target)
        kept = {name: value for name, value in os.environ.items() if name.endswith('SAN_OPTIONS')}
        self.environment = kept | {'PATH': f'{folder}/bin:{HERE}/bin:/usr/bin:/bin', 'HOME': f'{folder}/home',
                                   'LC_ALL': 'C.UTF-8', 'PYTHONUTF8': '1'}

    def answers(self, is_markdown, commands):
        """Returns: the lines that each command of a block answers, in a folder of their own."""
        folder = tempfile.mkdtemp(dir=self.folder)
        if is_markdown:
            self.sh((HERE / 'readme.sh').read_text(), folder).check_returncode()
        return [self.answer(is_markdown, command, folder) for command in commands]

    def sh(self, text, folder, given='', errors=subprocess.PIPE):
        return subprocess.run(['sh', '-c', text], cwd=folder, env=self.environment, check=False, stderr=errors,
                              stdout=subprocess.PIPE, input=given.encode('utf-8', 'surrogateescape'))

    def answer(self, is_markdown, command, folder):
        done = self.sh(command.text, folder, command.input, subprocess.STDOUT if is_markdown else subprocess.PIPE)
        out, code = lines_of(done.stdout, folder), done.returncode if done.returncode >= 0 else 128 - done.returncode
        if is_markdown and command.begin == command.end:
            return out + [f'= {code}'] if code != 0 else []
        if is_markdown:
            return out
        check(not any(map(MARK.match, out)), command.number, "output begins like a mark: append | sed 's/^/ /'")
        return out + [f'2> {line}' for line in lines_of(done.stderr or b'', folder)] + [f'= {code}'] * (code != 0)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program', type=pathlib.Path)
    parser.add_argument('files', metavar='FILE', nargs='*', type=pathlib.Path)
    parser.add_argument('--accept', action='store_true')
    parser.add_argument('--without', action='append', default=[], choices=NEEDS)
    given = parser.parse_args()
    given.files = given.files or [*sorted(HERE.glob('*.txt')), *(TOP / folder / 'README.md' for folder in ('.', 'walkthroughs'))]
    given.without += [] if shutil.which('ffmpeg') else ['ffmpeg']
    if not os.access(given.program, os.X_OK):
        parser.error(f'{given.program} is no program')
    return given


def differs(file, given, runner, pool):
    """Runs a file, shows what is answered otherwise than it says, and writes that where it is accepted."""
    is_markdown = file.suffix == '.md'
    lines = file.read_bytes().decode('utf-8', 'surrogateescape').split('\n')
    check(lines.pop() == '', len(lines) + 1, 'the last line does not end')
    blocks = (markdown if is_markdown else transcript)(lines, given.without)
    new, answers = list(lines), list(pool.map(lambda commands: runner.answers(is_markdown, commands), blocks))
    for command, answer in reversed([pair for two in zip(blocks, answers) for pair in zip(*two)]):
        new[command.begin:command.end] = merged(lines[command.begin:command.end], answer)
    left_out = sum(not commands for commands in blocks)
    print(f'{file}: {sum(map(len, blocks))} typed' + f', {left_out} left out' * (left_out > 0))
    for line in difflib.unified_diff(lines, new, f'{file}: expected', f'{file}: answered', lineterm=''):
        print(line)
    if given.accept and new != lines:
        file.write_bytes(''.join(line + '\n' for line in new).encode('utf-8', 'surrogateescape'))
    return new != lines


def main():
    given = arguments()
    sys.stdout.reconfigure(encoding='utf-8', errors='surrogateescape')
    different = []
    with tempfile.TemporaryDirectory(prefix='gjkstep-console-') as folder, \
            concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        runner = Runner(given.program.resolve(), pathlib.Path(folder))
        for file in given.files:
            try:
                different += [str(file)] if differs(file, given, runner, pool) else []
            except (OSError, Refused) as problem:
                sys.exit(f'{file}:{problem}')
    if different and not given.accept:
        again = ['python3', sys.argv[0], str(given.program), *different, '--accept']
        sys.exit('where the answers are right, write them into the transcripts:\n  ' + shlex.join(again))


if __name__ == '__main__':
    main()
