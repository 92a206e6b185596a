//! Calls in machine code, and programs that stop within one another.

use crate::execution::{run, run_at};
use crate::machine_code::lines;

#[test]
fn numbers_are_passed_on() {
    let listing = "
        num nSum
        num nCheck
        num nA[10]
        program six(num x_a, num x_b, num x_c, num x_d, num x_e, num x_f, num& x_r)
          num l_n
        begin
          x_b=x_b+x_a/2
          if x_a>0
            call six(x_a-1,x_c,x_d,x_e,x_f,x_b,l_n)
          endIf
          if (x_a==7) and (x_b>150)
            ? x_b+x_c*10+x_d*100+x_e*1000+x_f*10000
          endIf
          call deep(x_f)
          x_r=l_n+x_b-x_c*2+x_d*3-x_e*4+x_f+nA[x_a]
        end
        program deep(num x_n)
        begin
          nA[x_n%8]=nA[x_n%8]+1
          call other(x_n,nSum)
        end
        program other(num& x_n, num x_m)
        begin
          x_n=x_n+1
          nSum=x_m+x_n
        end
        program start()
          num i
          num l_n
        begin
          for i=1 to 160
            call six(i%8,i,i+1,i+2,i+3,i+4,l_n)
            nCheck=(nCheck*7+l_n)%1000003
          endFor
          ? nSum
          ? nCheck
        end";
    let printed = run(listing);
    assert_eq!(printed.lines().count(), 4, "{printed}");
    assert!(lines(listing) > 6_000, "{}", lines(listing));
}

#[test]
fn openings_and_long_programs() {
    let listing = "
        num nSum
        num nTicks
        bool bLate
        program long(num x_nGiven, num& x_nResult)
          num l_nI
        begin
          if x_nGiven<2
            x_nResult=x_nResult+x_nGiven
            return
          endIf
          for l_nI=1 to 3
            x_nResult=x_nResult+l_nI*x_nGiven
            call long(x_nGiven-l_nI,x_nResult)
          endFor
        end
        program pass(num x_nGiven, num& x_nResult)
          num l_nOwn
        begin
          l_nOwn=x_nResult
          call long(x_nGiven,l_nOwn)
          call long(x_nGiven,x_nResult)
          x_nResult=x_nResult%1000003-l_nOwn%7
        end
        program tick()
        begin
          nTicks=nTicks+1
          ? nSum
          if nTicks>30
            taskKill(\"tick\")
          endIf
        end
        program start()
          num l_nK
          num l_nResult
        begin
          taskCreateSync \"tick\",0.004,bLate,tick()
          for l_nK=1 to 60
            call pass(l_nK%6,l_nResult)
            nSum=nSum+l_nResult
          endFor
          ? nSum
          taskKill(\"tick\")
        end"
    .replace("\\\"", "\"");
    for line_cost in [2_000, 11_000, 17_000, 23_000] {
        run_at(&listing, line_cost);
    }
    assert!(lines(&listing) > 1_500, "{}", lines(&listing));
}

#[test]
fn programs_stop_within_one_another() {
    let listing = r#"
        num nA
        num nB
        num nC
        bool bLate
        num nTicks
        program third(num x_nGiven, num& x_nOne, num& x_nOther)
        begin
          x_nOne=x_nOne+x_nGiven
          if x_nGiven%5==0
            x_nOther=x_nOther+1
          endIf
          x_nOther=x_nOther+x_nOne%7
        end
        program second(num& x_nTo, num x_nGiven, num& x_nKept)
          num l_nOwn
        begin
          l_nOwn=x_nGiven
          call third(x_nGiven,l_nOwn,x_nKept)
          call third(l_nOwn%10,x_nKept,l_nOwn)
          call third(1,x_nTo,x_nTo)
          x_nTo=(x_nTo+l_nOwn)%1009
          x_nKept=x_nKept%997
        end
        program first(num x_nGiven, num& x_nResult)
          num l_nMine
          num l_nOther
        begin
          call second(l_nMine,x_nGiven,x_nResult)
          call second(x_nResult,x_nGiven+1,l_nMine)
          call second(l_nOther,l_nMine,x_nResult)
          nC=nC+l_nOther
        end
        program tick()
        begin
          nTicks=nTicks+1
          ? nA+nB*1000+nC*1000000
          if nTicks>200
            taskKill("tick")
          endIf
        end
        program start()
          num l_nK
          num l_nA
          num l_nB
          num l_nOwn
        begin
          taskCreateSync "tick",0.004,bLate,tick()
          delay(0.01)
          for l_nK=1 to 60
            call first(l_nK,l_nA)
            call first(l_nA,l_nOwn)
            call first(l_nOwn,l_nB)
            nA=l_nA
            nB=l_nB
          endFor
          ? l_nOwn
          taskKill("tick")
        end"#;
    for line_cost in (11_000..60_000).step_by(997) {
        run_at(listing, line_cost);
    }
    assert!(lines(listing) > 900, "{}", lines(listing));
}

#[test]
fn values_of_containers_are_passed_on() {
    let listing = r#"
        bool bFlags[9]
        num nA[7]
        num nG[3,4]
        num nOne
        bool bLate
        num nTicks
        program add(num x_nGiven, num& x_nTo, num& x_nCount)
        begin
          x_nTo=x_nTo+x_nGiven
          x_nCount=x_nCount+1
          if x_nTo>1000
            x_nTo=x_nTo-1000
          endIf
        end
        program row(num x_nI, num& x_nTo)
          num l_nJ
        begin
          for l_nJ=0 to 3
            call add(x_nI+l_nJ,nG[x_nI%3,l_nJ],x_nTo)
            call add(x_nTo,nA[(x_nI+l_nJ)%7],nOne)
            bFlags[x_nI%9]=nA[l_nJ]>500
          endFor
          call add(1,nOne,nA[6])
        end
        program tick()
        begin
          nTicks=nTicks+1
          ? nOne+nA[nTicks%7]*1000+nG[nTicks%3,nTicks%4]*1000000
          if nTicks>200
            taskKill("tick")
          endIf
        end
        program start()
          num l_nK
        begin
          taskCreateSync "tick",0.004,bLate,tick()
          delay(0.01)
          for l_nK=1 to 60
            call row(l_nK,nA[l_nK%6])
            call add(l_nK,nOne,nOne)
            if bFlags[l_nK%9]
              nA[0]=nA[0]+1
            endIf
          endFor
          ? nOne
          taskKill("tick")
        end"#;
    for line_cost in (11_000..60_000).step_by(997) {
        run_at(listing, line_cost);
    }
    assert!(lines(listing) > 1_000, "{}", lines(listing));
}

#[test]
fn calls_within_one_another_as_deep_as_machine_code_goes() {
    let listing = "
        num nDeep
        num nSum
        program other()
        begin
          nSum=nSum+nDeep*2+nSum%7
          if nSum>100000
            nSum=nSum-100000
          endIf
          nSum=nSum+nDeep%5+nSum/3-nSum%11
        end
        program down()
        begin
          nDeep=nDeep-1
          call other()
          if nDeep>0
            call other()
            call down()
          endIf
          call other()
          nSum=nSum+nDeep
        end
        program start()
          num l_nK
        begin
          for l_nK=1 to 30
            nDeep=10*l_nK
            call down()
          endFor
          ? nSum
        end";
    let printed = run(listing);
    assert!(!printed.contains("error"), "{printed}");
    assert!(lines(listing) > 60_000, "{}", lines(listing));
}

#[test]
fn computed_numbers_are_passed_on_by_the_interpreter_too() {
    let listing = "
        bool bAll[10]
        program add(num x_n, bool& x_bIs, num& x_nSum)
        begin
          x_bIs=!x_bIs
          x_nSum=(x_nSum+x_n)%1000
        end
        program start()
          num i
          num j
          num l_nSum
        begin
          for i=1 to 100
            for j=1 to 400
              l_nSum=l_nSum+j%7
            endFor
            call add(i*2+l_nSum,bAll[i%10],l_nSum)
            ? l_nSum
          endFor
        end";
    assert_eq!(run(listing).lines().count(), 100);
    assert!(lines(listing) > 8_000, "{}", lines(listing));
}

#[test]
fn computed_numbers_become_part_of_structures() {
    let listing = "
        trsf trAll[4]
        num nX
        program start()
          num i
          num j
          trsf l_trOne
        begin
          for i=1 to 200
            for j=1 to 400
              nX=nX+j%3
            endFor
            trAll[i%4]={i*2,i+1,nX%7,0,0,0}
            l_trOne={i/2,i*i,nX+1,0,0,0}
            if trAll[i%4]=={i*2,i+1,nX%7,0,0,0}
              nX=nX+l_trOne.x+trAll[(i+1)%4].y
            endIf
            if l_trOne!={i/2,i*i,nX+1,0,0,0}
              nX=nX+1
            endIf
            ? nX
          endFor
        end";
    assert_eq!(run(listing).lines().count(), 200);
    assert!(lines(listing) > 16_000, "{}", lines(listing));
}
