"""A collision test for judge_main.py to ask: sets whose boxes along the axes overlap may still be apart."""


def collide(a, b):
    return all(min(p[i] for p in a) <= max(q[i] for q in b) and min(q[i] for q in b) <= max(p[i] for p in a)
               for i in range(3))
