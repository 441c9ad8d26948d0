"""The exercises in C++: the solution passes; the start and typical wrong answers do not, and are told why."""

from __future__ import annotations

import pytest

from rosspin.exercises import check, judge, trace
from rosspin.exercises.own import Answer
from tests.helpers.answers import FILES, IN_CPP, NOTEBOOKS, TASKS

pytestmark = pytest.mark.shares(27)

NAMES = list(IN_CPP)


def test_so_many_are_offered_in_both_languages() -> None:
    both = [lesson.exercise for name, lesson in IN_CPP.items() if len(lesson.exercise.languages) == 2 and name in FILES]
    assert [sum(exercise.ros == ros for exercise in both) for ros in (1, 2)] == [5, 6]
    for ros, words in (1, "Five exercises are in C++, too"), (2, "Six exercises are in C++, too"):
        assert words in NOTEBOOKS[ros].read_text(encoding="utf-8")
    assert all(task.exercise.languages == ("python", "cpp") for task in TASKS)


@pytest.mark.parametrize("name", NAMES)
def test_the_start_is_not_right_and_the_solution_is(name: str) -> None:
    lesson = IN_CPP[name]
    start = check(name, lesson.node)
    assert not start.passed and start.hint
    assert "does not compile" not in repr(start)
    solution = check(name, lesson.changed)
    assert solution.passed, solution


def test_what_the_compiler_warns_of_comes_before_what_the_node_prints() -> None:
    solution = IN_CPP["make-it-10-hz"].changed
    feedback = check("make-it-10-hz", solution.replace("counter_++;", "counter_++;\n    if (counter_ = 3) {}"))
    assert not feedback.passed
    warning, *_, printed = feedback.console.splitlines()
    assert "answer.cpp:20:18: warning: using the result of an assignment as a condition" in warning
    assert "signal_handler" in printed


@pytest.mark.parametrize(("name", "answer"), [(name, answer) for name in NAMES for answer in IN_CPP[name].right[1:]])
def test_a_right_answer_passes_however_it_is_written(name: str, answer: Answer) -> None:
    feedback = check(name, IN_CPP[name].written(answer))
    assert feedback.passed, feedback


@pytest.mark.parametrize(("name", "wrong"), [(name, wrong) for name in NAMES for wrong in IN_CPP[name].wrong])
def test_a_wrong_answer_is_told_what_is_wrong_and_how_to_go_on(name: str, wrong: tuple[Answer, str, str]) -> None:
    answer, said, hint = wrong
    feedback = check(name, IN_CPP[name].written(answer))
    assert not feedback.passed
    assert not python_in(str(feedback))
    found = "\n".join(finding.text for finding in feedback.findings if not finding.right)
    assert said.lower() in found.lower()
    assert hint in feedback.hint


@pytest.mark.parametrize("name", NAMES)
def test_there_are_answers_enough(name: str) -> None:
    """Of the vehicle's tasks only a few: what they are judged by is tried in Python, too."""
    right, wrong = (4, 6) if name in FILES else (2, 3)
    assert len(IN_CPP[name].right) >= right and len(IN_CPP[name].wrong) >= wrong and len(IN_CPP[name].hints) >= 2


@pytest.mark.parametrize("name", NAMES)
def test_no_hint_speaks_of_python(name: str) -> None:
    for hint in (*IN_CPP[name].hints, IN_CPP[name].exercise.hints["cpp"]):
        assert not python_in(hint)


def python_in(text: str) -> list[str]:
    """The words of Python in what a student of C++ is told."""
    return [word for word in ("`self.", "rclpy", "rospy", "__init__", "Python", "None", "def ") if word in text]


def test_an_exercise_takes_answers_in_its_own_languages() -> None:
    node = IN_CPP["make-it-10-hz"].node
    for name in ("slow-timer", "wake-a-rate"):
        assert "This exercise takes an answer in Python." in str(check(name, node))


def test_it_is_judged_where_nothing_of_it_runs() -> None:
    name = "make-it-10-hz"
    for answer in (IN_CPP[name].changed, IN_CPP[name].node):
        assert judge(name, answer, trace(name, answer)) == check(name, answer)


def test_the_first_line_of_a_cell_is_none_of_it() -> None:
    """What the compiler says counts lines as the reader sees them."""
    broken = IN_CPP["make-it-10-hz"].written({"counter_++;": "counter_++"})
    line = broken.splitlines().index("    counter_++") + 1
    assert f"Line {line + 1}, column 15, does not compile: `expected ';'" in str(check("make-it-10-hz", f"\n{broken}"))


OUTSIDE = [
    '#include "/etc/passwd"',
    "#include </etc/passwd>",
    '#include "../../../../../../../../etc/passwd"',
    '#include "pyproject.toml"',
    "#include_next <../../etc/passwd>",
    'const unsigned char stolen[] = {\n#embed "/etc/passwd"\n};',
    'asm(".incbin \\"/etc/passwd\\"");',
    'asm(".include \\"/etc/passwd\\"");',
    '#pragma clang module import "/etc/passwd"',
    '#if __has_include("/etc/passwd")\n#error it is there\n#endif',
]


@pytest.mark.parametrize("line", OUTSIDE)
def test_to_compile_an_answer_reads_nothing_else(line: str) -> None:
    name = "make-it-10-hz"
    feedback = check(name, f"{line}\n{IN_CPP[name].changed}")
    said = str(feedback) + feedback.console
    assert "root:" not in said and "rosspin]" not in said and "it is there" not in said
    assert feedback.passed is ("__has_include" in line) or "does not compile" in said


READS = [
    'std::ifstream file("/etc/passwd"); std::string line; std::getline(file, line); std::cout << line << !file;',
    'std::cout << "got " << (std::fopen("/proc/self/environ", "r") == nullptr);',
    'std::cout << "got " << (std::getenv("HOME") == nullptr);',
    'std::cout << "got " << std::filesystem::exists("/etc");',
]


@pytest.mark.parametrize("line", READS)
def test_a_program_finds_no_file_of_this_computer(line: str) -> None:
    name = "make-it-10-hz"
    includes = "".join(f"#include <{each}>\n" for each in ("cstdio", "cstdlib", "filesystem", "fstream", "iostream"))
    answer = IN_CPP[name].written(
        {"rclcpp::init(argc, argv);": f"rclcpp::init(argc, argv); {line} std::cout << std::endl;"}
    )
    feedback = check(name, includes + answer)
    assert "root:" not in feedback.console
