//! Machine code does what the interpreter does: [`run`] executes each program with and without.

use std::fmt::Write as _;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use val3_native::MachineCode;
use val3_vm::{Native, Prospect, Stretch};

use crate::execution::{LINE_COST, events, run, run_at};
use crate::show::image;

/// Machine code that counts the lines it has executed.
#[derive(Debug)]
struct Counted(MachineCode, Arc<AtomicU64>);

impl Native for Counted {
    fn run(&mut self, work: &mut Stretch<'_>) -> Prospect {
        let before = work.budget;
        let prospect = self.0.run(work);
        self.1.fetch_add(u64::from(before - work.budget), Ordering::Relaxed);
        prospect
    }
}

/// How many lines of a program machine code executes.
pub(crate) fn lines(listing: &str) -> u64 {
    let count = Arc::new(AtomicU64::new(0));
    events(&Arc::new(image(listing)), Some(Box::new(Counted(MachineCode::after(0), Arc::clone(&count)))), LINE_COST);
    count.load(Ordering::Relaxed)
}

#[test]
fn numbers_arrays_and_calls_are_machine_code() {
    let loops = "
        num nSum
        program start()
          num i
          num j
        begin
          for i=1 to 100
            j=i
            while j>0
              if j%3==0
                nSum=nSum+i*j
              else
                nSum=nSum-j/2
              endIf
              j=j-1
            endWhile
          endFor
        end";
    let arrays = "
        num nA[100]
        num nG[10,10]
        program start()
          num i
          num j
          num l_nB[50]
        begin
          for i=0 to 99
            nA[i]=i*i
          endFor
          for i=0 to 9
            for j=0 to 9
              nG[i,j]=nA[i*10+j]
              l_nB[i+j]=nG[j,i]
            endFor
          endFor
        end";
    let calls = "
        program fib(num x_n, num& x_r)
          num l_a
          num l_b
        begin
          if x_n<2
            x_r=x_n
            return
          endIf
          call fib(x_n-1,l_a)
          call fib(x_n-2,l_b)
          x_r=l_a+l_b
        end
        program start()
          num n
        begin
          call fib(15,n)
        end";
    let functions = "
        num nSum
        program start()
          num i
        begin
          for i=1 to 1000
            nSum=nSum+sqrt(abs(sin(i)))+max(i,500)
            nSum=bAnd(round(nSum),65535)+sel(i>500,power(i,0.5),atan(i))
          endFor
        end";
    for (listing, least) in [(loops, 20_000), (arrays, 500), (calls, 6_000), (functions, 2_900)] {
        let found = lines(listing);
        assert!(found > least, "{found} lines of {listing}");
    }
}

#[test]
fn quotients_and_remainders_by_constants() {
    let mut listing = "num nSum\nprogram start()\nnum i\nnum x\nbegin\nfor i=-40 to 40\n".to_owned();
    for number in ["i", "i/3", "i*77309411.5", "i*0.1+2147483646", "i*i*i*i*i*1e9", "i*1e300*1e300", "-i*0"] {
        writeln!(listing, "x={number}").unwrap();
        for divisor in ["1", "2", "3", "-3", "7", "0.5", "-8", "1024", "0.1", "2147483647", "2147483648", "1e-300"] {
            writeln!(listing, "? x/{divisor}\n? x%{divisor}").unwrap();
        }
    }
    let printed = run(&(listing + "endFor\nend"));
    assert_eq!(printed.lines().filter(|line| !line.starts_with("error")).count(), 81 * 7 * 12 * 2);
}

#[test]
fn indexes_are_rounded() {
    let indexes = ["i", "i/2", "i-0.5", "i*0.49999999999999994", "i*0.5000000000000001", "i/2+0.49999999999999994"];
    for index in indexes {
        let listing = format!(
            "num nA[8]\nnum nG[4,8]\nprogram start()\nnum i\nnum j\nbegin\nfor i=0 to 7\nnA[i]=i+1\nfor j=0 to 3\n\
             nG[j,i]=10*j+i\nendFor\nendFor\nfor i=0 to 7\n? nA[{index}]\n? nG[i/2,{index}]\nendFor\nend\n"
        );
        let printed = run(&listing);
        assert_eq!(printed.lines().count(), 16, "{index}: {printed}");
        assert!(lines(&listing) > 90, "{index}");
    }
    let just_below_half = "num nA[2]\nprogram start()\nnum i\nbegin\nnA[1]=1\nfor i=0.49999999999999994 to 1\n\
         nA[0]=nA[i]+5\n? nA[0]\nendFor\nend\n";
    assert_eq!(run(just_below_half), "5\n", "in the interpreter and in machine code");
    for index in ["-i-1", "i-0.6", "i+7.5", "i*1e300*1e300-i", "4294967296+i", "1/3-i*1e15"] {
        run(&format!("num nA[8]\nprogram start()\nnum i\nbegin\nfor i=0 to 7\n? nA[{index}]\nendFor\nend\n"));
    }
}

#[test]
fn sines_have_the_same_bits() {
    for angle in ["i*15", "i*7.3", "i*i*i*1234.567", "i*0.25e-9", "i*4e9", "i*1e300*1e300"] {
        // The bits of the larger half, then the others.
        let print =
            |function| format!("y=round({function}(x)*67108864)\n? y\n? ({function}(x)*67108864-y)*134217728\n");
        let listing = format!(
            "program start()\nnum i\nnum x\nnum y\nbegin\nfor i=-200 to 200\nx={angle}\n{}{}endFor\nend\n",
            print("sin"),
            print("cos")
        );
        assert_eq!(run(&listing).lines().count(), 401 * 4);
        let found = lines(&listing.replace("? ", "y="));
        assert!(found > 401 * 7 || angle.contains('e'), "{found} lines with {angle}");
    }
}

#[test]
fn truth_values_in_containers() {
    let listing = "
        bool bAny
        bool bSieve[200]
        bool bGrid[6,9]
        num nCount
        program turn(bool& x_bOne, bool& x_bAll[], num x_nFrom)
          num i
        begin
          x_bOne=!x_bOne
          for i=x_nFrom to 199 step x_nFrom
            x_bAll[i]=true
          endFor
        end
        program start()
          num i
          num j
          bool l_bOdd[10]
          bool l_bLast
        begin
          for i=2 to 199
            if !bSieve[i]
              nCount=nCount+1
              for j=i*i to 199 step i
                bSieve[j]=i!=j
              endFor
            endIf
            l_bOdd[i%10]=i%2==1
            bGrid[i%6,i%9]=l_bOdd[i%7] or bSieve[i-1]
            bAny=bGrid[(i*7)%6,i%9] xor l_bOdd[i/22]
            if bAny and (i%3==0)
              nCount=nCount+1000
            endIf
          endFor
          ? nCount
          for i=1 to 60
            call turn(bAny,bSieve,i)
            call turn(bSieve[i],bSieve,i+1)
            call turn(l_bLast,l_bOdd,200+i)
            call turn(l_bOdd[i/7],bSieve,i+3)
          endFor
          for i=0 to 199
            ? bSieve[i]
            ? bGrid[i%6,i%9]
            ? l_bOdd[i/22]
          endFor
          ? bAny
          ? l_bLast
        end";
    let printed = run(listing);
    assert_eq!(printed.lines().count(), 603, "{printed}");
    assert!(lines(listing) > 1_500, "{}", lines(listing));
}

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
fn others_have_their_turns_at_the_same_times() {
    let computing = "
        num nCount
        num nTicks
        bool bLate
        program watch()
        begin
          while true
            ? nCount
            ? clock()
            delay(0.05)
          endWhile
        end
        program tick()
        begin
          while true
            nTicks=nTicks+1
            delay(0)
          endWhile
        end
        program start()
          num i
        begin
          for i=1 to 60000
            nCount=nCount+i%7
          endFor
          ? clock()
          taskCreate \"watch\",10,watch()
          for i=1 to 60000
            nCount=nCount-i%7
          endFor
          ? clock()
          taskCreateSync \"tick\",0.02,bLate,tick()
          for i=1 to 60000
            nCount=nCount+1
          endFor
          ? clock()
          taskKill(\"watch\")
          taskKill(\"tick\")
          delay(0)
          for i=1 to 60000
            nCount=nCount+1
          endFor
          ? clock()
          ? nTicks
        end";
    let printed = run(computing);
    assert_eq!(printed.lines().last(), Some("12"), "{printed}");
    // Lines that end behind the end of a cycle.
    for line_cost in [1_700, 2_999, 7_001] {
        run_at(computing, line_cost);
    }
    assert!(lines(computing) > 300_000);
}

#[test]
fn errors_come_where_they_come_from() {
    for (line, error) in [
        ("nX=nA[i]", 20),
        ("nX=nA[5-i]", 21),
        ("nX=i/(i-9)", 10),
        ("nX=i%(i-9)", 10),
        ("nX=sqrt(5-i)", 11),
        ("nX=ln(9-i)", 11),
        ("nX=asin(i/10-0.05)", 11),
        ("nX=exp(i*100)", 11),
        ("nG[i,i]=1", 20),
        ("call deep(i)", 41),
    ] {
        let listing = format!(
            "num nX\nnum nA[8]\nnum nG[20,5]\nprogram deep(num x_n)\nbegin\nnX=nX+1\nif x_n>5\ncall deep(x_n+1)\n\
             endIf\nend\nprogram start()\nnum i\nbegin\nfor i=0 to 100\nnX=nX+1\n{line}\nendFor\nend\n"
        );
        let printed = run(&listing);
        assert!(printed.starts_with(&format!("error {error} ")), "{line}: {printed}");
        assert!(lines(&listing) > 0, "{line}");
    }
}

#[test]
fn whole_numbers_stay_exact() {
    let listing = r#"
        num nA[6]
        num nX
        num nBytes[8]
        program start()
          num l_nUp
          num l_nZero
          num l_nRound
          num l_nK
        begin
          for l_nRound=1 to 6
            nX=nX+nA[l_nZero]
            // Where one more makes no difference.
            l_nUp=9007199254740988
            for l_nK=1 to 9
              if l_nUp<6
                nX=nX+nA[l_nUp]
              endIf
              l_nUp=l_nUp+1
            endFor
            ? l_nUp-9007199254740000
            for l_nK=1 to 9
              l_nUp=l_nUp-4503599627370495
            endFor
            ? l_nUp+27021597764223000
            l_nUp=9007199254740991
            l_nUp=l_nUp*l_nUp
            ? l_nUp/1e20
            l_nUp=3037000501
            l_nUp=l_nUp*l_nUp
            ? l_nUp-9223372042963000000
            // The negative zero.
            l_nUp=-3
            l_nUp=l_nUp*l_nZero
            nA[5]=l_nUp
            toBinary(nA[5],1,"8.0l",nBytes)
            ? nBytes[7]
            l_nUp=0
            l_nUp=l_nUp*(-1)
            for l_nUp=0 to 9007199254740989 step 4503599627370495
              nX=nX+1
            endFor
            ? l_nUp-9007199254740000
            ? nX
          endFor
        end"#;
    let printed = run(listing);
    assert_eq!(printed.lines().count(), 42, "{printed}");
    assert!(lines(listing) > 10, "{} {printed}", lines(listing));
}

#[test]
fn what_a_block_knows_of_an_index_ends_with_it() {
    let listing = "
        num nA[6]
        num nX
        program start()
          num l_nAt
          num l_nRound
        begin
          for l_nRound=1 to 8
            l_nAt=9007199254740986+l_nRound%2
            while l_nAt>0
              if l_nAt<6
                nX=nX+nA[l_nAt]
              endIf
              l_nAt=l_nAt+3
              if l_nAt>9007199254740993
                nX=nX+(l_nAt-9007199254740000)
                l_nAt=-1
              endIf
            endWhile
            ? nX
          endFor
        end";
    assert_eq!(run(listing).lines().count(), 8);
    assert!(lines(listing) > 10);
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
