//! Run-time errors of tasks: 29, 30, 31, 32, 70 and 90 (5.10).

use expect_test::expect;

use crate::execution::{check, errors};

#[test]
fn wrong_task_names_are_errors() {
    errors(
        "string sLong=\"abcdefghijklmnop\"",
        &[
            "taskCreate left(sLong,15),10,work()",
            "taskCreate sLong,10,work()",
            "taskCreate \"\",10,work()",
            "taskCreate \"a b\",10,work()",
            "taskCreate \"9_Z\",10,work()",
            "taskCreate \"line\",10,work()",
        ],
        expect![[r#"
            -1 taskCreate left(sLong,15),10,work()
            29 taskCreate sLong,10,work()
            29 taskCreate '',10,work()
            29 taskCreate 'a b',10,work()
            -1 taskCreate '9_Z',10,work()
            31 taskCreate 'line',10,work()
        "#]],
    );
}

#[test]
fn wrong_priorities_are_errors() {
    errors(
        "num nValue",
        &[
            "taskCreate \"p1\",1,work()",
            "taskCreate \"p100\",100,work()",
            "taskCreate \"p0\",l_nValue,work()",
            "taskCreate \"p101\",l_nValue+101,work()",
            "taskCreate \"p_1\",l_nValue-1,work()",
        ],
        expect![[r#"
            -1 taskCreate 'p1',1,work()
            -1 taskCreate 'p100',100,work()
            70 taskCreate 'p0',l_nValue,work()
            70 taskCreate 'p101',l_nValue+101,work()
            70 taskCreate 'p_1',l_nValue-1,work()
        "#]],
    );
}

#[test]
fn wrong_periods_are_errors() {
    errors(
        "bool bLate",
        &[
            "taskCreateSync \"a\",0.004,bLate,work()",
            "taskCreateSync \"b\",l_nValue,bLate,work()",
            "taskCreateSync \"c\",l_nValue-1,bLate,work()",
            "taskCreateSync \"d\",0.004,l_bFlag,work()",
        ],
        expect![[r#"
            -1 taskCreateSync 'a',0.004,bLate,work()
            70 taskCreateSync 'b',l_nValue,bLate,work()
            70 taskCreateSync 'c',l_nValue-1,bLate,work()
            70 taskCreateSync 'd',0.004,l_bFlag,work()
        "#]],
    );
}

#[test]
fn unknown_tasks_are_errors() {
    errors(
        "num nValue",
        &[
            "taskSuspend(\"nobody\")",
            "taskResume(\"nobody\",0)",
            "taskKill(\"nobody\")",
            "l_bFlag=taskStatus(\"nobody\")==-1",
        ],
        expect![[r#"
            30 taskSuspend('nobody')
            30 taskResume('nobody',0)
            -1 taskKill('nobody')
            -1 l_bFlag=taskStatus('nobody')==-1
        "#]],
    );
}

#[test]
fn a_local_variable_is_no_reference() {
    errors(
        "num nValue\nnum nArray[2]",
        &[
            "taskCreate \"a\",10,take(nValue)",
            "taskCreate \"b\",10,take(l_nValue)",
            "taskCreate \"c\",10,takeAll(nArray)",
            "taskCreate \"d\",10,takeAll(l_nValue)",
        ],
        expect![[r#"
            -1 taskCreate 'a',10,take(nValue)
            70 taskCreate 'b',10,take(l_nValue)
            -1 taskCreate 'c',10,takeAll(nArray)
            70 taskCreate 'd',10,takeAll(l_nValue)
        "#]],
    );
}

#[test]
fn an_error_in_an_argument_is_that_of_the_creator() {
    check(
        r#"
        num nZero
        program work(num x_nValue)
        begin
        end
        program create()
        begin
          taskCreate "work",10,work(1/nZero)
        end
        program start()
        begin
          taskCreate "create",10,create()
          wait(taskStatus("create")!=1)
          ? taskStatus("create")
          ? taskStatus("work")
          taskKill("create")
        end
        "#,
        expect![[r#"
            error 10
            10
            -1
        "#]],
    );
}
