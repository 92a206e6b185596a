//! Machine code does what the interpreter does: [`run`] executes each program with and without.

use std::fmt::Write as _;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use val3_native::MachineCode;
use val3_vm::{Native, Prospect, Stretch};

use crate::execution::{LINE_COST, events, run, run_at, started};
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
fn a_counter_that_leaves_the_exact_numbers_is_counted_once() {
    let listing = "
        num nA[6]
        num nX
        program start()
          num i
          num l_nRound
          num l_nK
        begin
          for l_nRound=1 to 20
            for l_nK=1 to 50
              for i=0 to 5
                nX=nX+nA[i]+1
              endFor
            endFor
            for i=0 to 9007199254740990 step 4503599627370495
              nX=nX+1
            endFor
            ? i-13510798882110000
            ? nX
          endFor
        end";
    assert_eq!(run(listing).lines().count(), 40);
    assert!(lines(listing) > 1_000, "{}", lines(listing));
}

/// Whoever stops a run by hand waits as long.
#[test]
fn others_outside_can_look_again_and_again() {
    let listing = "num nX\nprogram start()\nbegin\nwhile true\nnX=power(nX%100+1,0.5)+nX/3\nendWhile\nend";
    let mut controller = started(&Arc::new(image(listing)), Some(Box::new(MachineCode::after(0))), LINE_COST);
    controller.expect_quiet(400_000_000 * LINE_COST);
    for _ in 0..3 {
        let before = controller.now();
        controller.step();
        let lines = (controller.now() - before) / LINE_COST;
        assert!(lines < 10_000_000, "{lines} lines");
    }
    assert!(controller.now() > 3_000_000 * LINE_COST, "machine code goes on beyond the end of a cycle");
}
