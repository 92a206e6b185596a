//! `wait`, `watch`, `delay` and `clock` (5.10).

use expect_test::expect;

use crate::execution::check;

#[test]
fn a_delay_takes_its_time() {
    check(
        r#"
        num nFrom
        program start()
        begin
          nFrom=clock()
          delay(0.5)
          ? round((clock()-nFrom)*1000)
          delay(0.003)
          ? round((clock()-nFrom)*1000)
          delay(0)
          delay(-3)
          ? round((clock()-nFrom)*1000)
        end
        "#,
        expect![[r#"
            500
            503
            503
        "#]],
    );
}

#[test]
fn a_watch_ends_with_its_condition_or_its_time() {
    check(
        r#"
        bool bSeen
        bool bSignal
        num nFrom
        program signal()
        begin
          delay(0.25)
          bSignal=true
        end
        program start()
        begin
          taskCreate "s",10,signal()
          nFrom=clock()
          ? watch(bSignal,0.1)
          ? round((clock()-nFrom)*1000)
          ? watch(bSignal,5)
          ? round((clock()-nFrom)*1000)
          ? watch(bSignal,0)
          ? watch(!bSignal,0)
          ? watch(!bSignal,-1)
          bSeen=watch(!bSignal,1)
          ? bSeen
          ? round((clock()-nFrom)*1000)
        end
        "#,
        expect![[r#"
            false
            100
            true
            250
            true
            false
            false
            false
            1250
        "#]],
    );
}

#[test]
fn a_wait_sees_every_change() {
    check(
        r#"
        num nValue
        program count()
        begin
          while nValue<10
            delay(0.1)
            nValue=nValue+1
          endWhile
        end
        program start()
        begin
          taskCreate "s",10,count()
          wait(nValue==4)
          ? round(clock()*100)
          wait(clock()>=2.5)
          ? round(clock()*100)
          wait(nValue==10)
          ? round(clock()*100)
        end
        "#,
        expect![[r#"
            40
            250
            250
        "#]],
    );
}

#[test]
fn a_wait_sees_the_end_of_a_task_after_its_condition() {
    check(
        r#"
        bool bMutex
        num nZero
        bool bWatched
        program sleep()
        begin
          delay(0.1)
        end
        program lock()
        begin
          setMutex(bMutex)
        end
        program look()
        begin
          bWatched=watch(bWatched,0.2)
        end
        program fail()
        begin
          wait(bWatched and 1/nZero>0)
        end
        program start()
        begin
          taskCreate "sleep",10,sleep()
          wait(taskStatus("sleep")==-1)
          ? clock()
          taskCreate "look",10,look()
          wait(taskStatus("look")==-1)
          ? clock()
          bMutex=true
          taskCreate "lock",10,lock()
          delay(0.1)
          bMutex=false
          wait(taskStatus("lock")==-1)
          ? bMutex
          taskCreate "fail",10,fail()
          delay(0.1)
          bWatched=true
          wait(taskStatus("fail")!=1)
          ? taskStatus("fail")
        end
        "#,
        expect![[r#"
            0.1
            0.3
            true
            error 10
            10
        "#]],
    );
}
