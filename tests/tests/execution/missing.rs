//! Applications with missing parts: they start, and the line that needs the part stops its task (6.4, 6.6).

use expect_test::expect;

use crate::execution::check;

#[test]
fn a_missing_interface_stops_the_task_at_its_use() {
    check(
        r#"
        library io "Disk://io/io.pjx"
        num nValue
        program read()
        begin
          nValue=1
          nValue=io:nInput[2]+1
        end
        program ask()
        begin
          while io:bReady
            nValue=2
          endWhile
        end
        program stop()
        begin
          call io:work(nValue)
        end
        program tasks()
        begin
          taskCreate "io",10,io:work(1)
        end
        program start()
        begin
          ? isDefined(io:nInput)
          ? isDefined(io:nInput[2])
          ? io:libExist("nInput")
          taskCreate "read",10,read()
          taskCreate "ask",10,ask()
          taskCreate "call",10,stop()
          taskCreate "create",10,tasks()
          wait(taskStatus("read")==80 and taskStatus("ask")==80)
          wait(taskStatus("call")==80 and taskStatus("create")==80)
          ? nValue
          taskResume("read",1)
          delay(0)
          ? taskStatus("read")
        end
        "#,
        expect![[r#"
            false
            false
            false
            error 80
            error 80
            error 80
            error 80
            1
            -1
        "#]],
    );
}

#[test]
fn a_missing_item_stops_the_task_at_its_use() {
    check(
        r#"
        library part "Disk://part/part.pjx"
        program start()
        begin
          ? isDefined(part:nOld)
          ? part:nOld
        end
        --- part
        public num nNew
        "#,
        expect![[r#"
            false
            error 80
        "#]],
    );
}

#[test]
fn a_missing_condition_stops_when_it_is_evaluated() {
    check(
        r#"
        num nCount
        program start()
        begin
          if nCount==0
            ? "if"
          elseIf $ask(1)
            ? "elseIf"
          endIf
          for nCount=1 to 2
            ? nCount
          endFor
          do
            ? "do"
          until $ask(2)
          ? "behind"
        end
        "#,
        expect![[r#"
            if
            1
            2
            do
            line 15: no $ask
        "#]],
    );
}

#[test]
fn missing_items_in_loops_and_switches_stop_the_task() {
    let body = |line: &str| format!("num nCount\nprogram start()\nbegin\n  ? 1\n  {line}\nend\n");
    for line in [
        "for nCount=1 to $last()\n    ? 2\n  endFor",
        "switch $which()\n    case 1\n      ? 2\n    break\n  endSwitch",
        "while $more()\n    ? 2\n  endWhile",
        "? $value()",
        "$act()",
        "nCount=nCount+$value()",
        "wait($more())",
    ] {
        let printed = val3_tests::running::Running::start(&body(line)).to_the_end().printed();
        let name = line.split_once('$').unwrap().1.split_once('(').unwrap().0;
        assert_eq!(printed, format!("1\nline 6: no ${name}\n"), "{line}");
    }
}

#[test]
fn missing_user_types_stop_the_task() {
    check(
        r#"
        type Slot "Disk://Slot/Slot.pjx"
        type Row "Disk://Row/Row.pjx"
        Slot sFirst
        Row rFirst
        program work(Slot& x_sSlot)
        begin
          ? "work"
        end
        program start()
          Slot l_sSlot
        begin
          rFirst.nCount=3
          ? rFirst.nCount
          call work(l_sSlot)
        end
        --- Row
        type Slot "Disk://Slot/Slot.pjx"
        public num nCount
        public Slot sSlot
        "#,
        expect![[r#"
            3
            line 10: no Slot
        "#]],
    );
}
