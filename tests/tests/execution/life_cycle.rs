//! Start and end of an application (2.1.3, 5.2).

use expect_test::expect;
use val3_machine::event::EventKind;
use val3_tests::running::Running;

use crate::execution::check;

/// Returns the events of tasks and the output of `?`, in lines.
fn story(running: &Running) -> String {
    let line = |kind: &EventKind| match kind {
        EventKind::Task { state, name, .. } => Some(format!("{name} {state}\n")),
        EventKind::Print { text } => Some(format!("{text}\n")),
        _ => None,
    };
    running.events.iter().filter_map(|event| line(&event.kind)).collect()
}

#[test]
fn stop_runs_when_the_last_task_has_ended() {
    let running = Running::start(
        r#"
        program work()
        begin
          delay(2)
          ? clock()
        end
        program start()
        begin
          taskCreate "work",10,work()
          ? taskStatus("main~")
        end
        program stop()
        begin
          ? taskStatus("main~")
          ? taskStatus("~main")
          call start()
        end
        "#,
    );
    expect![[r#"
        main~ created
        work created
        1
        main~ ended
        2
        work ended
        ~main created
        -1
        1
        work created
        -1
        ~main ended
        work killed
    "#]]
    .assert_eq(&story(&running.to_the_end()));
}

#[test]
fn start_and_stop_can_be_called() {
    check(
        r#"
        bool bAgain
        program start()
        begin
          ? "start"
          if !bAgain
            bAgain=true
            call start()
            call stop()
            ? "the application goes on"
          endIf
        end
        program stop()
        begin
          ? "stop"
        end
        "#,
        expect![[r#"
            start
            start
            stop
            the application goes on
            stop
        "#]],
    );
}

const STOPPED: &str = r#"
    program work()
    begin
      while true
        delay(1)
      endWhile
    end
    program start()
    begin
      taskCreate "z",10,work()
      taskCreate "a",10,work()
      delay(100)
    end
    program stop()
    begin
      ? clock()
      ? taskStatus("z")
      taskCreate "m",10,work()
      delay(3)
      ? clock()
    end
    "#;

#[test]
fn stopped_from_outside_it_kills_tasks_in_the_reverse_order() {
    let mut running = Running::start(STOPPED).for_seconds(5);
    running.controller.stop();
    expect![[r#"
        main~ created
        z created
        a created
        main~ killed
        ~main created
        5
        1
        m created
        8
        ~main ended
        m killed
        a killed
        z killed
    "#]]
    .assert_eq(&story(&running.to_the_end()));
}

#[test]
fn equal_applications_have_equal_records() {
    let bytes = || {
        let running = Running::start(STOPPED).for_seconds(5);
        running.events.iter().map(|event| serde_json::to_string(event).unwrap() + "\n").collect::<String>()
    };
    assert!(bytes().len() > 100);
    assert_eq!(bytes(), bytes());
}

#[test]
fn a_stop_after_the_end_of_start_is_seen_by_other_tasks() {
    let mut running = Running::start(
        r#"
        bool bEnd
        program work()
        begin
          wait(bEnd)
          ? "told"
          wait(false)
        end
        program start()
        begin
          taskCreate "work",10,work()
        end
        program stop()
        begin
          bEnd=true
          delay(0.1)
        end
        "#,
    )
    .for_seconds(2);
    running.controller.stop();
    running.controller.stop();
    expect![[r#"
        main~ created
        work created
        main~ ended
        ~main created
        told
        ~main ended
        work killed
    "#]]
    .assert_eq(&story(&running.to_the_end()));
}

/// Public programs end themselves in this way.
#[test]
fn an_application_ends_where_it_kills_its_start_task() {
    let running = Running::start(
        r#"
        program watchdog()
        begin
          delay(1)
          taskKill("main~")
          ? taskStatus("main~")
        end
        program start()
        begin
          taskCreate "watchdog",10,watchdog()
          while true
            delay(0.1)
          endWhile
        end
        program stop()
        begin
          ? "stopped"
        end
        "#,
    );
    expect![[r#"
        main~ created
        watchdog created
        main~ killed
        -1
        watchdog ended
        ~main created
        stopped
        ~main ended
    "#]]
    .assert_eq(&story(&running.to_the_end()));
}

#[test]
fn the_start_task_may_kill_itself() {
    check(
        r#"
        program start()
        begin
          taskKill("main~")
          ? "never"
        end
        program stop()
        begin
          taskKill("main~")
          taskKill("~main")
          ? "never"
        end
        "#,
        expect![""],
    );
}
