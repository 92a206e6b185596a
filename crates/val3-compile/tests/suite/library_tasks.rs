//! Tasks of libraries: their visibility and their end (2.1.3, 5.2, 5.3).

use expect_test::{Expect, expect};
use val3_machine::event::EventKind;

use crate::cell::{Cell, run};

#[track_caller]
fn check(listing: &str, expected: Expect) {
    expected.assert_eq(&Cell::new(listing).run());
}

#[test]
fn a_task_is_seen_where_it_was_created() {
    check(
        r#"
        library part "Disk://part/part.pjx"
        program work()
        begin
          delay(1)
        end
        program try()
        begin
          taskSuspend("own")
        end
        program start()
        begin
          call part:init()
          ? taskStatus("own")
          taskKill("own")
          call part:tell()
          taskCreate "try",10,try()
          wait(taskStatus("try")!=1)
          taskKill("try")
          taskCreate "own",10,work()
          ? taskStatus("own")
          taskSuspend("own")
          call part:tell()
          ? taskStatus("own")
          taskKill("own")
          call part:tell()
          call part:finish()
          call part:tell()
        end
        --- part
        program work()
        begin
          delay(100)
        end
        public program init()
        begin
          taskCreate "own",10,work()
        end
        public program tell()
        begin
          ? "library "+toString("",taskStatus("own"))
        end
        public program finish()
        begin
          taskKill("own")
        end
        "#,
        expect![[r#"
            -1
            library 1
            error 30 in try
            1
            library 1
            0
            library 1
            library -1
        "#]],
    );
}

#[test]
fn the_creator_counts_and_not_the_program() {
    check(
        r#"
        library part "Disk://part/part.pjx"
        program start()
        begin
          taskCreate "own",10,part:work()
          ? taskStatus("own")
          call part:tell()
          delay(2)
        end
        --- part
        public program work()
        begin
          ? taskStatus("own")
          delay(1)
        end
        public program tell()
        begin
          ? taskStatus("own")
        end
        "#,
        expect![[r#"
            1
            -1
            -1
        "#]],
    );
}

#[test]
fn tasks_of_libraries_end_with_the_application_the_newest_first() {
    let cell = Cell::new(
        r#"
        library part "Disk://part/part.pjx"
        program start()
        begin
          call part:init("z")
          call part:init("a")
          call part:init("m")
          delay(1)
        end
        program stop()
        begin
          delay(1)
          ? clock()
        end
        --- part
        program work()
        begin
          wait(false)
        end
        public program init(string x_sName)
        begin
          taskCreate x_sName,10,work()
        end
        "#,
    );
    let events = run(&mut cell.controller(), |_| {});
    let lines = events.iter().filter_map(|event| match &event.kind {
        EventKind::Task { state, name, .. } => Some(format!("{name} {state}\n")),
        EventKind::Print { text } => Some(format!("{text}\n")),
        _ => None,
    });
    let story: String = lines.collect();
    expect![[r#"
        main~ created
        z created
        a created
        m created
        main~ ended
        ~main created
        2.004
        ~main ended
        m killed
        a killed
        z killed
    "#]]
    .assert_eq(&story);
}

#[test]
fn a_library_that_was_not_loaded_stops_a_task_of_its_user_alone() {
    check(
        r#"
        library part "Disk://part/part.pjx" autoload=false
        num nWeight
        program use()
        begin
          nWeight=part:nWeight
        end
        program call_it()
        begin
          call part:init()
        end
        program start()
        begin
          taskCreate "use",10,use()
          taskCreate "call",10,call_it()
          wait(taskStatus("use")!=1 and taskStatus("call")!=1)
          ? taskStatus("use")
          ? taskStatus("call")
          ? part:libLoad("part")
          taskResume("use",0)
          taskResume("call",0)
          wait(taskStatus("use")==-1 and taskStatus("call")==-1)
          ? nWeight
        end
        --- part
        public num nWeight=7
        public program init()
        begin
          ? "init"
        end
        "#,
        expect![[r#"
            error 80 in use
            error 80 in call_it
            80
            80
            0
            init
            7
        "#]],
    );
}

#[test]
fn data_that_a_program_has_by_reference_stay() {
    check(
        r#"
        library part "Disk://part/part.pjx"
        bool bGo
        num nOwn
        program value(num& x_n)
        begin
          wait(bGo)
          ? x_n
        end
        program row(num& x_a[])
        begin
          ? part:libLoad("other")
          ? size(x_a)
        end
        program start()
        begin
          call row(part:nRow[1])
          taskCreate "user",10,value(part:nValue)
          delay(0.1)
          ? part:libLoad("other")
          bGo=true
          delay(0.1)
          ? part:libLoad("other")
          taskCreateSync "tells",0.004,part:bLate,value(nOwn)
          bGo=false
          ? part:libLoad("part")
          taskKill("tells")
          ? part:libLoad("part")
        end
        --- part
        public num nValue=3
        public num nRow[3]
        public bool bLate
        --- other
        public num nValue=4
        public num nRow[4]
        public bool bLate
        "#,
        expect![[r#"
            13
            2
            13
            3
            0
            13
            0
        "#]],
    );
}
