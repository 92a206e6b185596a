//! Tasks that wait for each other (5.8, 5.9).

use expect_test::expect;

use crate::execution::check;

#[test]
fn tasks_continue_after_a_common_event() {
    check(
        r#"
        num n
        bool bSynch
        string sTrace
        program synchro(num& x_n, bool& x_bSynch, num x_nN)
        begin
          x_n=x_n+1
          wait((x_n==x_nN) or (x_bSynch==true))
          x_bSynch=true
          x_n=x_n-1
          wait((x_n==0) or (x_bSynch==false))
          x_bSynch=false
        end
        program work(string x_sMark, num x_nTime)
          num l_nRound
        begin
          for l_nRound=1 to 3
            delay(x_nTime)
            sTrace=sTrace+x_sMark
            call synchro(n,bSynch,3)
          endFor
        end
        program start()
        begin
          taskCreate "a",10,work("a",0.3)
          taskCreate "b",10,work("b",0.1)
          taskCreate "c",10,work("c",0.2)
          wait(taskStatus("a")==-1 and taskStatus("b")==-1 and taskStatus("c")==-1)
          ? sTrace
          ? n
          ? bSynch
        end
        "#,
        expect![[r#"
            bcabcabca
            0
            false
        "#]],
    );
}

#[test]
fn one_task_at_a_time_has_the_screen() {
    check(
        r#"
        bool bScreen
        string sTrace
        program fill(num x_nC)
          num l_nX
          num l_nY
        begin
          setMutex(bScreen)
          x_nC=x_nC%10
          sTrace=sTrace+toString("",x_nC)
          for l_nX=0 to 39
            for l_nY=0 to 13
              gotoxy(l_nX,l_nY)
              put(x_nC)
            endFor
          endFor
          delay(0.2)
          sTrace=sTrace+toString("",x_nC)
          bScreen=false
        end
        program start()
        begin
          taskCreate "a",10,fill(11)
          taskCreate "b",100,fill(2)
          taskCreate "c",50,fill(33)
          wait(taskStatus("a")==-1 and taskStatus("b")==-1 and taskStatus("c")==-1)
          ? sTrace
          ? bScreen
        end
        "#,
        expect![[r#"
            112233
            false
        "#]],
    );
}
