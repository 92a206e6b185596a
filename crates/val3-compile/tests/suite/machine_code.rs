//! Machine code does what the interpreter does: [`run`] executes each program with and without.

use std::fmt::Write as _;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use proptest::prelude::*;
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
fn lines(listing: &str) -> u64 {
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

/// What a statement is made of, by numbers: the same for the same numbers.
#[derive(Debug, Clone)]
enum Statement {
    Assign(String, String),
    If(String, Vec<Self>, Vec<Self>),
    For(String, Vec<Self>),
    While(Vec<Self>),
    Call(&'static str, String, String),
    /// With the whole numbers `l_nU` and `l_nV` and the truth value `l_bIs`.
    Count(&'static str),
    Print(String),
    Leave(String),
}

fn variable() -> impl Strategy<Value = String> {
    let indexed =
        (prop::sample::select(vec!["nA", "l_nB"]), 0..6).prop_map(|(array, index)| format!("{array}[{index}]"));
    let computed =
        prop::sample::select(vec!["nA[l_nI]", "l_nB[l_nJ/2]", "nG[l_nI,1]", "nG[1,l_nJ]"]).prop_map(str::to_owned);
    let plain = prop::sample::select(vec!["l_nI", "l_nJ", "l_nK", "nX", "nY"]).prop_map(str::to_owned);
    prop_oneof![6 => plain, 1 => indexed, 2 => computed]
}

/// Instructions that make a number of numbers, with what they take.
const FUNCTIONS: [(&str, usize); 17] = [
    ("abs", 1),
    ("bAnd", 2),
    ("bNot", 1),
    ("bOr", 2),
    ("bXor", 2),
    ("cos", 1),
    ("exp", 1),
    ("limit", 3),
    ("ln", 1),
    ("max", 2),
    ("min", 2),
    ("power", 2),
    ("round", 1),
    ("roundDown", 1),
    ("roundUp", 1),
    ("sin", 1),
    ("sqrt", 1),
];

/// What becomes of whole numbers, also of those that are too large to be exact, and of truth values.
const COUNTS: [&str; 17] = [
    "l_nU=0",
    "l_nU=l_nU+1",
    "l_nU=l_nV",
    "l_nU=l_nU-l_nV",
    "l_nU=l_nU*l_nV",
    "l_nV=3",
    "l_nV=l_nV+l_nU",
    "l_nV=-2",
    "l_nV=9007199254740990",
    "for l_nU=0 to 5\nnA[l_nU]=nA[l_nU]+l_nV\nendFor",
    "for l_nU=5 to 1 step -2\nnX=nA[l_nU]*l_nU\nendFor",
    "if l_nU>=0 and l_nU<6\nnY=nY+nA[l_nU]\nbSeen[l_nU]=!bSeen[l_nU]\nendIf",
    "if l_nV>=0 and l_nV<=5\nl_bIs=bSeen[l_nV]\nnG[1,l_nV/2]=l_nU\nendIf",
    "l_bIs=l_nU<l_nV",
    "if l_bIs\nnX=nX+1\nl_bIs=false\nendIf",
    "bSeen[2]=l_bIs",
    "nX=nA[l_nU]",
];

fn call_of(((name, takes), a, b, c): ((&str, usize), String, String, String)) -> String {
    let arguments: Vec<String> = [a, b, c].into_iter().take(takes).collect();
    format!("{name}({})", arguments.join(","))
}

fn expression() -> impl Strategy<Value = String> {
    let number = prop::sample::select(vec!["0", "1", "2", "3", "-1", "0.5", "7", "1e9"]).prop_map(str::to_owned);
    let leaf = prop_oneof![3 => variable(), 2 => number];
    leaf.prop_recursive(3, 8, 2, |inner| {
        let operator = prop::sample::select(vec!["+", "-", "*", "+", "-", "/", "%"]);
        prop_oneof![
            4 => (inner.clone(), operator, inner.clone()).prop_map(|(a, operator, b)| format!("({a}{operator}{b})")),
            1 => inner.clone().prop_map(|a| format!("(-{a})")),
            1 => (prop::sample::select(FUNCTIONS.to_vec()), inner.clone(), inner.clone(), inner).prop_map(call_of),
        ]
    })
}

fn condition() -> impl Strategy<Value = String> {
    let operator = prop::sample::select(vec!["<", "<=", ">", ">=", "==", "!="]);
    let compared =
        (expression(), operator, expression()).prop_map(|(a, operator, b)| format!("{a}{operator}{b}")).boxed();
    let pair = (compared.clone(), prop::sample::select(vec!["and", "or", "xor"]), compared.clone());
    prop_oneof![3 => compared, 1 => pair.prop_map(|(a, operator, b)| format!("({a}) {operator} !({b})"))]
}

fn statements() -> impl Strategy<Value = Vec<Statement>> {
    let leaf = prop_oneof![
        6 => (variable(), expression()).prop_map(|(to, value)| Statement::Assign(to, value)),
        1 => (prop::sample::select(vec!["twice", "both", "down"]), expression(), variable())
            .prop_map(|(name, given, result)| Statement::Call(name, given, result)),
        2 => prop::sample::select(COUNTS.to_vec()).prop_map(Statement::Count),
        1 => expression().prop_map(Statement::Print),
        1 => condition().prop_map(Statement::Leave),
    ];
    let statement = leaf.prop_recursive(3, 16, 4, |inner| {
        let block = prop::collection::vec(inner, 1..4);
        prop_oneof![
            2 => (condition(), block.clone(), block.clone()).prop_map(|(on, yes, no)| Statement::If(on, yes, no)),
            2 => ("[1-9]", block.clone()).prop_map(|(to, body)| Statement::For(to, body)),
            1 => block.prop_map(Statement::While),
        ]
    });
    prop::collection::vec(statement, 2..7)
}

/// The text of statements; each loop has a counter of its own, so that it ends.
fn write(statements: &[Statement], loops: &mut u32, text: &mut String) {
    for statement in statements {
        match statement {
            Statement::Assign(to, value) => writeln!(text, "{to}={value}").unwrap(),
            Statement::If(on, yes, no) => {
                writeln!(text, "if {on}").unwrap();
                write(yes, loops, text);
                text.push_str("else\n");
                write(no, loops, text);
                text.push_str("endIf\n");
            }
            Statement::For(to, body) => {
                *loops += 1;
                let counter = format!("l_n{loops}");
                let step = if (*loops).is_multiple_of(2) { "" } else { " step 0.5" };
                writeln!(text, "for {counter}=0 to {to}{step}").unwrap();
                write(body, loops, text);
                text.push_str("endFor\n");
            }
            Statement::While(body) => {
                *loops += 1;
                let counter = format!("l_n{loops}");
                writeln!(text, "{counter}=0\nwhile {counter}<5\n{counter}={counter}+1").unwrap();
                write(body, loops, text);
                text.push_str("endWhile\n");
            }
            Statement::Call(name, given, result) => writeln!(text, "call {name}({given},{result})").unwrap(),
            Statement::Count(count) => writeln!(text, "{count}").unwrap(),
            Statement::Print(value) => writeln!(text, "? {value}").unwrap(),
            Statement::Leave(on) => writeln!(text, "if {on}\nnY=nY+1\nreturn\nendIf").unwrap(),
        }
    }
}

/// An application whose program `work` consists of statements.
fn application(statements: &[Statement]) -> String {
    let (mut body, mut loops) = (String::new(), 0);
    write(statements, &mut loops, &mut body);
    let counters: String = (1..=loops).fold(String::new(), |text, number| text + &format!("num l_n{number}\n"));
    format!(
        "num nX\nnum nY\nnum nA[6]\nnum nG[3,4]\nbool bSeen[6]\n\
         program twice(num x_nGiven, num& x_nResult)\nbegin\nif x_nGiven>100\nreturn\nendIf\n\
         x_nResult=x_nGiven*2+x_nResult\nnX=x_nResult\nend\n\
         program both(num x_nGiven, num& x_nResult)\nnum l_nHalf\nbegin\ncall twice(x_nGiven/2,l_nHalf)\n\
         call twice(l_nHalf,x_nResult)\nx_nGiven=nX+l_nHalf\ncall twice(x_nGiven,nY)\nend\n\
         program down(num x_nGiven, num& x_nResult)\nnum l_nLess\nbegin\nif !(x_nGiven>0.5)\nx_nResult=x_nResult+1\nreturn\nendIf\n\
         if x_nGiven>10\nx_nGiven=10\nendIf\ncall down(x_nGiven-1,l_nLess)\ncall down(x_nGiven-4,x_nResult)\n\
         x_nResult=x_nResult+l_nLess\nend\n\
         program work(num x_nRound, num& x_nDone)\nnum l_nI\nnum l_nJ\nnum l_nK\nnum l_nU\nnum l_nV\nbool l_bIs\nnum l_nB[6]\n{counters}begin\n\
         l_nI=x_nRound%4\nl_nJ=3\nx_nDone=x_nDone+1\n{body}end\n\
         program start()\nnum l_nRound\nnum l_nDone\nbegin\nfor l_nRound=1 to 40\ncall work(l_nRound,l_nDone)\nendFor\n\
         ? nX\n? nY\n? l_nDone\n? nA[1]\n? nG[1,1]\nend\n"
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_program_does_the_same(statements in statements()) {
        let listing = application(&statements);
        run(&listing);
        assert!(lines(&listing) > 0, "no machine code for {listing}");
    }
}
