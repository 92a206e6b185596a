//! Statements (2.2.5).

use expect_test::expect;

use crate::execution::check;

#[test]
fn arguments_come_before_locals_and_each_call_has_its_own() {
    check(
        r#"
        program count(num x_nDown)
          num l_nOwn
        begin
          l_nOwn=l_nOwn+x_nDown
          if x_nDown>0
            call count(x_nDown-1)
          endIf
          ? l_nOwn
        end
        program start()
        begin
          call count(3)
          call count(1)
        end
        "#,
        expect![[r#"
            0
            1
            2
            3
            0
            1
        "#]],
    );
}

#[test]
fn return_ends_the_program_or_the_task() {
    check(
        r#"
        program leave(num x_nValue)
        begin
          if x_nValue>1
            ? "left"
            return
          endIf
          ? "stayed"
        end
        program start()
        begin
          call leave(1)
          call leave(2)
          taskCreate "own",10,leave(3)
          wait(taskStatus("own")==-1)
          ? "ended"
          return
          ? "never"
        end
        "#,
        expect![[r#"
            stayed
            left
            left
            ended
        "#]],
    );
}

#[test]
fn if_takes_the_first_branch_that_is_true() {
    check(
        r#"
        string sDay
        num nDay
        program day()
        begin
          if sDay=="Monday"
            nDay=1
          elseIf sDay=="Tuesday"
            nDay=2
          elseIf sDay!="Sunday"
            nDay=3
          elseIf sDay=="Sunday"
            nDay=9
          else
            nDay=99
          endIf
          ? nDay
        end
        program start()
        begin
          sDay="Monday"
          call day()
          sDay="Tuesday"
          call day()
          sDay="Friday"
          call day()
          sDay="Sunday"
          call day()
        end
        "#,
        expect![[r#"
            1
            2
            3
            9
        "#]],
    );
}

#[test]
fn loops_test_before_or_after() {
    check(
        r#"
        num nCount
        program start()
        begin
          while nCount>0
            ? "never"
          endWhile
          do
            nCount=nCount+1
            ? nCount
          until true
          while nCount<3
            nCount=nCount+1
            ? nCount
          endWhile
        end
        "#,
        expect![[r#"
            1
            2
            3
        "#]],
    );
}

#[test]
fn for_counts_until_the_end_is_passed() {
    check(
        r#"
        string sSeen
        num nPos
        program start()
        begin
          for nPos=90 to -90 step -60
            sSeen=sSeen+toString("",nPos)+" "
          endFor
          ? sSeen+toString("",nPos)
          sSeen=""
          for nPos=5 to 4
            sSeen="never"
          endFor
          ? sSeen+toString("",nPos)
          for nPos=4 to 5 step -1
            sSeen="never"
          endFor
          ? sSeen+toString("",nPos)
          for nPos=0 to 1 step 0.25
            sSeen=sSeen+toString("",nPos)+" "
          endFor
          ? sSeen
          sSeen=""
          for nPos=1 to 9
            nPos=nPos+1
            sSeen=sSeen+toString("",nPos)+" "
          endFor
          ? sSeen
        end
        "#,
        expect![[r#"
            90 30 -30 -90 -150
            5
            4
            0 0 0 1 1
            2 4 6 8 10
        "#]],
    );
}

#[test]
fn the_end_and_the_step_of_a_loop_are_taken_once() {
    check(
        r#"
        num nPos
        num nEnd=3
        num nStep=1
        program start()
        begin
          for nPos=1 to nEnd step nStep
            ? nPos
            if nPos==2
              nEnd=6
              nStep=2
            endIf
          endFor
          ? nPos
        end
        "#,
        expect![[r#"
            1
            2
            3
            4
        "#]],
    );
}

#[test]
fn switch_compares_values_of_one_type() {
    check(
        r#"
        num nMenu
        string sDay
        program menu()
        begin
          switch nMenu
            case 271
              ? "Menu 1"
            break
            case 272
              ? "Menu 2"
            break
            case 273,274,275,276,277,278
              ? "Menu 3 to 8"
            break
            default
              ? "this key is not a menu key"
            break
          endSwitch
        end
        program start()
        begin
          for nMenu=270 to 280 step 2
            call menu()
          endFor
          switch sDay
            case "Monday"
              ? 1
            break
            case sDay
              ? "itself"
            break
          endSwitch
          switch true
            case nMenu>1000
              ? "large"
            break
            case nMenu>100
              ? "middle"
            break
            case nMenu>10
              ? "small"
            break
          endSwitch
        end
        "#,
        expect![[r#"
            this key is not a menu key
            Menu 2
            Menu 3 to 8
            Menu 3 to 8
            Menu 3 to 8
            this key is not a menu key
            itself
            middle
        "#]],
    );
}
