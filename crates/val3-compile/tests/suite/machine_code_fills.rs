//! Machine code fills arrays at once as the interpreter does element by element.

use std::fmt::Write as _;

use crate::execution::{run, run_at};
use crate::machine_code::lines;

/// Prints of each array how many elements have which values, and where they change.
const SHOW: &str = "
    program show(num& x_nAll[])
      num k
    begin
      for k=0 to 999
        if k==0
          ? x_nAll[0]
        elseIf x_nAll[k]!=x_nAll[k-1]
          ? k
          ? x_nAll[k]
        endIf
      endFor
    end
    program showTruth(bool& x_bAll[])
      num k
    begin
      for k=1 to 999
        if x_bAll[k]!=x_bAll[k-1]
          ? k
          ? x_bAll[k]
        endIf
      endFor
    end";

#[test]
fn elements_from_the_first_to_the_last_become_the_value() {
    for (first, last) in [("0", "999"), ("1", "998"), ("300", "999"), ("0", "499.5"), ("744", "999"), ("743", "999")] {
        let steps = ["", "step 2", "step 0.5"];
        for (to, step) in [last, "nLast"].iter().flat_map(|to| steps.map(|step| (to, step))) {
            let head = format!("for i={first} to {to} {step}");
            let mut body = String::new();
            for store in [
                "nAll[i]=7",
                "nMore[i]=x",
                "bMore[i]=true",
                "bAll[i]=x>2",
                "bAll[i]=l_bIs",
                "nMore[i]=i",
                "nAll[i]=-0.0",
            ] {
                writeln!(body, "{head}\n{store}\nendFor\n? i\nx=x+1").unwrap();
                writeln!(body, "call show(nAll)\ncall show(nMore)\ncall showTruth(bAll)\ncall showTruth(bMore)")
                    .unwrap();
            }
            let listing = format!(
                "num nAll[1000]\nbool bAll[1000]\nbool bMore[1000]\nnum nMore[1000]\nnum nLast\n{SHOW}\nprogram start()\n\
                 num i\nnum x\nbool l_bIs\nbegin\nx=2.5\nnLast={last}\n{body}end"
            );
            let printed = run(&listing);
            assert!(printed.lines().count() > 6, "{printed} of {listing}");
            let found = lines(&listing);
            assert!(found > 2_000, "{found} lines of {listing}");
        }
    }
}

#[test]
fn arrays_by_reference_are_filled_from_where_they_begin() {
    let listing = format!(
        "num nAll[1000]\nbool bAll[1000]\n{SHOW}
        program clear(num& x_nAll[], bool& x_bAll[], num x_nLast)
          num i
        begin
          for i=2 to x_nLast
            x_nAll[i]=x_nLast
          endFor
          for i=3 to x_nLast-5
            x_bAll[i]=!x_bAll[0]
          endFor
          for i=3 to x_nLast-7
            x_bAll[i]=true
          endFor
        end
        program start()
          num l_nRound
        begin
          for l_nRound=0 to 3
            call clear(nAll[100*l_nRound],bAll[17*l_nRound],600-l_nRound)
            call show(nAll)
            call showTruth(bAll)
          endFor
          taskCreate \"clear\",10,clear(nAll[5],bAll[6],900)
          delay(1)
          call show(nAll)
          call showTruth(bAll)
        end"
    );
    assert!(run(&listing).lines().count() > 30);
    assert!(lines(&listing) > 10_000);
}

#[test]
fn a_loop_beyond_the_array_stops_behind_the_last_element() {
    for (first, last, error) in [("0", "1000", 20), ("500", "1e9", 20), ("-3", "999", 21), ("2000", "3000", 20)] {
        let listing = format!(
            "num nAll[1000]\n{SHOW}\nprogram fill()\nnum i\nbegin\nfor i={first} to {last}\nnAll[i]=4\nendFor\nend\n\
             program start()\nbegin\nnAll[3]=1\ntaskCreate \"fill\",10,fill()\ndelay(1)\ncall show(nAll)\nend"
        );
        let printed = run(&listing);
        assert!(printed.contains(&format!("error {error} ")), "{printed}");
    }
}

#[test]
fn others_see_as_many_elements_as_lines_have_begun() {
    let listing = "
        num nAll[2000]
        num nRound
        bool bLate
        bool bAny[2000]
        program look()
          num k
          num l_nSeen
        begin
          while true
            l_nSeen=0
            for k=13 to 1999 step 50
              l_nSeen=l_nSeen*1.01+nAll[k]
              if bAny[k]
                l_nSeen=l_nSeen+1000
              endIf
            endFor
            ? l_nSeen
            delay(0)
          endWhile
        end
        program start()
          num i
          num l_nPinned[3]
          num l_nOwn[300]
        begin
          taskCreateSync \"look\",0.02,bLate,look()
          for nRound=1 to 6
            for l_nPinned[nRound%3]=1 to 2
              for i=0 to 1999
                nAll[i]=nRound
              endFor
              for i=0 to 1999
                bAny[i]=true
              endFor
              for i=1 to 1999
                bAny[i]=false

              endFor
              for i=0 to 299
                l_nOwn[i]=nRound
              endFor
              ? l_nOwn[0]+l_nOwn[298]+l_nOwn[299]
            endFor
          endFor
          ? l_nPinned[0]+l_nPinned[1]+l_nPinned[2]
          taskKill(\"look\")
        end";
    for line_cost in [2_000, 7_001, 13_000, 29_000, 31_007] {
        let printed = run_at(listing, line_cost);
        assert!(printed.lines().count() > 12, "{printed}");
    }
    assert!(lines(listing) > 10_000);
}

#[test]
fn a_task_goes_on_from_the_line_that_it_was_suspended_in() {
    let listing = "
        num nAll[5000]
        program fill()
          num i
        begin
          while true
            while nAll[1]>=0
              for i=0 to 4999
                nAll[i]=nAll[0]+i*0
              endFor
              for i=0 to 4999
                nAll[i]=3
              endFor
              nAll[0]=nAll[0]+1
            endWhile
            nAll[0]=nAll[0]+10
            nAll[0]=nAll[0]+20
          endWhile
        end
        program start()
          num k
        begin
          taskCreate \"fill\",10,fill()
          for k=1 to 24
            delay(0.0173*k)
            taskSuspend(\"fill\")
            ? taskStatus(\"fill\")
            ? nAll[0]+nAll[2500]*100+nAll[4999]*10000
            taskResume(\"fill\",k%3)
          endFor
          taskKill(\"fill\")
        end";
    for line_cost in [2_000, 5_003, 8_999] {
        let printed = run_at(listing, line_cost);
        assert_eq!(printed.lines().count(), 48, "{printed}");
    }
}

#[test]
fn programs_that_call_themselves_fill_their_own_arrays() {
    let listing = "
        num nAll[800]
        num nTicks
        bool bLate
        program deep(num x_nLevel)
          num i
        begin
          for i=0 to 700+x_nLevel
            nAll[i]=x_nLevel
          endFor
          i=0
          if x_nLevel>0
            call deep(x_nLevel-1)
          endIf
          for i=0 to 300+x_nLevel
            nAll[i]=-x_nLevel
          endFor
        end
        program tick()
        begin
          while true
            nTicks=nTicks+1
            ? nAll[(nTicks*37)%800]
            delay(0)
          endWhile
        end
        program start()
        begin
          taskCreateSync \"tick\",0.008,bLate,tick()
          call deep(5)
          ? nAll[0]+nAll[303]+nAll[702]
          call deep(4)
          taskKill(\"tick\")
        end";
    for line_cost in [2_000, 7_001, 13_000, 29_000, 31_007] {
        assert!(run_at(listing, line_cost).lines().count() > 2);
    }
}
