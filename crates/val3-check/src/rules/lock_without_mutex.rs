//! V0340: a flag that several tasks test and set without `setMutex`.

use val3_analysis::application::locks;
use val3_lang::instructions::SET_MUTEX;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// Several tasks wait for a flag and set it on the next line, as a lock.
    ///
    /// ## Why
    /// Tasks take turns between lines. Two of them may both read `false` from the flag before either sets it, and both
    /// continue. This happens rarely, and only on the machine. `setMutex` waits for the flag and sets it within one
    /// line. The task that has set the flag resets it to `false`, as before.
    ///
    /// ## Bad
    /// ```val3
    /// bool bScreen
    ///
    /// program start()
    /// begin
    ///   taskCreate "left",10,show(1)
    ///   taskCreate "right",10,show(2)
    /// end
    ///
    /// program show(num x_nLine)
    /// begin
    ///   wait(bScreen==false)
    ///   bScreen=true
    ///   gotoxy(0,x_nLine)
    ///   put(x_nLine)
    ///   bScreen=false
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bScreen
    ///
    /// program start()
    /// begin
    ///   taskCreate "left",10,show(1)
    ///   taskCreate "right",10,show(2)
    /// end
    ///
    /// program show(num x_nLine)
    /// begin
    ///   setMutex(bScreen)
    ///   gotoxy(0,x_nLine)
    ///   put(x_nLine)
    ///   bScreen=false
    /// end
    /// ```
    V0340 "lock-without-mutex" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for lock in locks(program.body) {
        let is_data = program.items.data.contains_key(&lock.flag) && !hides(program, &lock.flag);
        let application = program.application();
        let programs = application.locks.get(&lock.flag).into_iter().flatten();
        if is_data && application.tasks_at_once(programs) > 1 {
            found.report(&RULE, lock.set, word(&lock.flag)).related(lock.test, "it is tested here");
        }
    }
}

fn hides(program: &ProgramView<'_>, name: &str) -> bool {
    let header = program.header;
    header.locals.iter().any(|local| local.name == name) || header.params.iter().any(|param| param.name == name)
}

fn word(flag: &str) -> Wording {
    Wording::new(
        format!("another task may set `{flag}` between the test and this line"),
        "not locked",
        format!("`{SET_MUTEX}({flag})` waits for it and sets it within one line"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn tasks(code: &str) -> String {
        let tasks = "taskCreate \"a\",10,p()\ntaskCreate \"b\",10,q()\nprogram q()\nbegin\n  call p()\nend\n";
        check(&RULE, &format!("bool bA\nbool bB\n{tasks}program p()\nbegin\n{code}\nend"))
    }

    #[test]
    fn locks_by_waits_tests_and_loops_are_reported() {
        expect![[r#"
            p.pgx:6 `bA=true` another task may set `bA` between the test and this line
              | not locked
              ? `setMutex(bA)` waits for it and sets it within one line
              > p.pgx:5 `bA==false and bB` it is tested here
            p.pgx:8 `bA=true` another task may set `bA` between the test and this line
              | not locked
              ? `setMutex(bA)` waits for it and sets it within one line
              > p.pgx:7 `!bA` it is tested here
            p.pgx:13 `bB=true` another task may set `bB` between the test and this line
              | not locked
              ? `setMutex(bB)` waits for it and sets it within one line
              > p.pgx:10 `bB!=false` it is tested here
        "#]]
        .assert_eq(&tasks(
            "wait(bA==false and bB)\nbA=true\nif !bA\nbA=true\nendIf\nwhile bB!=false\ndelay(0)\nendWhile\nbB=true",
        ));
    }

    #[test]
    fn another_test_or_another_flag_is_not_reported() {
        assert_eq!(
            tasks("wait(bA==true)\nbA=true\nwait(bA==false)\nbB=true\nwait(!bA)\nbA=false\nif bA\nbA=true\nendIf"),
            ""
        );
        assert_eq!(tasks("wait(bA==false)\ncls()\nbA=true"), "");
        assert_eq!(tasks("setMutex(bA)\nbA=false"), "");
    }

    #[test]
    fn flags_of_a_single_task_are_not_reported() {
        let program = "program p()\nbegin\n  wait(bA==false)\n  bA=true\nend";
        assert_eq!(check(&RULE, &format!("bool bA\ntaskCreate \"a\",10,p()\n{program}")), "");
        let local = "program p()\n  bool bA\nbegin\n  wait(bA==false)\n  bA=true\nend";
        assert_eq!(check(&RULE, &format!("bool bA\ntaskCreate \"a\",10,p()\ntaskCreate \"b\",10,p()\n{local}")), "");
    }

    #[test]
    fn a_flag_that_another_task_takes_back_is_not_reported() {
        let listing = "bool bA\ntaskCreate \"a\",10,p()\ntaskCreate \"b\",10,q()\n\
                       program p()\nbegin\n  wait(bA==false)\n  bA=true\nend\n\
                       program q()\nbegin\n  wait(bA==true)\n  bA=false\nend";
        assert_eq!(check(&RULE, listing), "");
    }
}
