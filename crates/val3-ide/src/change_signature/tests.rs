use expect_test::{Expect, expect};
use val3_analysis::items::program::header;
use val3_lang::types::Container;

use super::*;
use crate::assists::shown;
use crate::testing::MarkedListing;

/// A new parameter that is passed by value.
fn added(name: &str, type_name: &str, argument: &str) -> NewParameter {
    NewParameter {
        from: None,
        name: name.to_owned(),
        type_name: type_name.to_owned(),
        container: Container::Element,
        by_reference: false,
        argument: argument.to_owned(),
    }
}

fn local(name: &str, type_name: &str, sizes: &[u32]) -> NewLocal {
    NewLocal { from: None, name: name.to_owned(), type_name: type_name.to_owned(), sizes: sizes.to_vec() }
}

/// Changes the variables of the program with `$0`, and returns the changed files or the error message.
fn done(listing: &str, change: impl Fn(&mut NewVariables)) -> String {
    let marked = MarkedListing::new(listing);
    let (db, file) = (marked.db(), marked.at().file);
    let mut wanted = NewVariables::of(header(db, file));
    change(&mut wanted);
    match change_signature(db, file, &wanted) {
        Ok(change) => shown(db, &change),
        Err(error) => format!("refused: {}\n", error.0),
    }
}

fn check(listing: &str, change: impl Fn(&mut NewVariables), expected: Expect) {
    expected.assert_eq(&done(listing, change));
}

const PICK: &str = "call pick(1,\"a\")\n\
    program pick(num x_nA,string x_sB)\nbegin\n  $0put(x_sB)\n  put(x_nA)\nend\n\
    program third()\nbegin\n  taskCreate \"t\",10,pick(2, \"b\")\nend";

#[test]
fn parameters_change_places() {
    check(
        PICK,
        |wanted| wanted.parameters.swap(0, 1),
        expect![[r#"
            usrapp/main/pick.pgx
            -      <Parameter name="x_nA" type="num" xsi:type="element" />
            -      <Parameter name="x_sB" type="string" xsi:type="element" />
            +      <Parameter name="x_sB" type="string" xsi:type="element" />
            +      <Parameter name="x_nA" type="num" xsi:type="element" />
            usrapp/main/start.pgx
            -call pick(1,"a")
            +call pick("a",1)
            usrapp/main/third.pgx
            -  taskCreate "t",10,pick(2, "b")
            +  taskCreate "t",10,pick("b", 2)
        "#]],
    );
}

#[test]
fn parameters_are_renamed() {
    check(
        PICK,
        |wanted| wanted.parameters[0].name = "x_nC".to_owned(),
        expect![[r#"
        usrapp/main/pick.pgx
        -      <Parameter name="x_nA" type="num" xsi:type="element" />
        -      <Parameter name="x_sB" type="string" xsi:type="element" />
        -    </Parameters>
        -    <Code><![CDATA[begin
        -  put(x_sB)
        -  put(x_nA)
        +      <Parameter name="x_nC" type="num" xsi:type="element" />
        +      <Parameter name="x_sB" type="string" xsi:type="element" />
        +    </Parameters>
        +    <Code><![CDATA[begin
        +  put(x_sB)
        +  put(x_nC)
    "#]],
    );
    check(
        PICK,
        |wanted| {
            wanted.parameters[0].name = "x_sB".to_owned();
            wanted.parameters[1].name = "x_nA".to_owned();
        },
        expect![[r#"
            usrapp/main/pick.pgx
            -      <Parameter name="x_nA" type="num" xsi:type="element" />
            -      <Parameter name="x_sB" type="string" xsi:type="element" />
            -    </Parameters>
            -    <Code><![CDATA[begin
            -  put(x_sB)
            -  put(x_nA)
            +      <Parameter name="x_sB" type="num" xsi:type="element" />
            +      <Parameter name="x_nA" type="string" xsi:type="element" />
            +    </Parameters>
            +    <Code><![CDATA[begin
            +  put(x_nA)
            +  put(x_sB)
        "#]],
    );
}

#[test]
fn parameters_are_added() {
    check(
        PICK,
        |wanted| wanted.parameters.insert(1, added("x_bC", "bool", "1<2")),
        expect![[r#"
        usrapp/main/pick.pgx
        +      <Parameter name="x_bC" type="bool" xsi:type="element" />
        usrapp/main/start.pgx
        -call pick(1,"a")
        +call pick(1,1<2,"a")
        usrapp/main/third.pgx
        -  taskCreate "t",10,pick(2, "b")
        +  taskCreate "t",10,pick(2, 1<2, "b")
    "#]],
    );
    check(
        "call pick()\nprogram pick()\nbegin\n  $0put(1)\nend",
        |wanted| wanted.parameters.push(added("x_bC", "bool", "true")),
        expect![[r#"
            usrapp/main/pick.pgx
            +    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
            +      <Parameter name="x_bC" type="bool" xsi:type="element" />
            +    </Parameters>
            usrapp/main/start.pgx
            -call pick()
            +call pick(true)
        "#]],
    );
}

#[test]
fn parameters_are_removed() {
    let listing = "call pick(1,2,3)\nprogram pick(num x_nA,num x_nB,num x_nC)\nbegin\n  $0put(x_nB)\nend";
    check(
        listing,
        |wanted| drop(wanted.parameters.remove(0)),
        expect![[r#"
        usrapp/main/pick.pgx
        -      <Parameter name="x_nA" type="num" xsi:type="element" />
        usrapp/main/start.pgx
        -call pick(1,2,3)
        +call pick(2,3)
    "#]],
    );
    check(
        listing,
        |wanted| drop(wanted.parameters.remove(2)),
        expect![[r#"
        usrapp/main/pick.pgx
        -      <Parameter name="x_nC" type="num" xsi:type="element" />
        usrapp/main/start.pgx
        -call pick(1,2,3)
        +call pick(1,2)
    "#]],
    );
    check(
        listing,
        |wanted| wanted.parameters.clear(),
        expect![[r#"
        refused: the parameter `x_nB` is used once in `pick`
    "#]],
    );
    check(
        "call pick(1)\nprogram pick(num x_nA)\nbegin\n  $0put(1)\nend",
        |wanted| wanted.parameters.clear(),
        expect![[r#"
            usrapp/main/pick.pgx
            -    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
            -      <Parameter name="x_nA" type="num" xsi:type="element" />
            -    </Parameters>
            usrapp/main/start.pgx
            -call pick(1)
            +call pick()
        "#]],
    );
}

#[test]
fn arguments_of_calls_of_itself_change_along() {
    check(
        "call pick(1,2,3)\nprogram pick(num x_nA,num x_nB,num x_nC)\nbegin\n  $0put(x_nB+x_nC)\n  call pick(x_nA,x_nB+1,x_nC)\nend",
        |wanted| {
            wanted.parameters.remove(0);
            wanted.parameters.swap(0, 1);
            wanted.parameters[1].name = "x_nD".to_owned();
        },
        expect![[r#"
            usrapp/main/pick.pgx
            -      <Parameter name="x_nA" type="num" xsi:type="element" />
            -      <Parameter name="x_nB" type="num" xsi:type="element" />
            -      <Parameter name="x_nC" type="num" xsi:type="element" />
            -    </Parameters>
            -    <Code><![CDATA[begin
            -  put(x_nB+x_nC)
            -  call pick(x_nA,x_nB+1,x_nC)
            +      <Parameter name="x_nC" type="num" xsi:type="element" />
            +      <Parameter name="x_nD" type="num" xsi:type="element" />
            +    </Parameters>
            +    <Code><![CDATA[begin
            +  put(x_nD+x_nC)
            +  call pick(x_nC,x_nD+1)
            usrapp/main/start.pgx
            -call pick(1,2,3)
            +call pick(3,2)
        "#]],
    );
}

#[test]
fn parameters_are_passed_otherwise_and_retyped() {
    check(
        PICK,
        |wanted| {
            wanted.parameters[0].by_reference = true;
            wanted.parameters[1].type_name = "num".to_owned();
        },
        expect![[r#"
            usrapp/main/pick.pgx
            -      <Parameter name="x_nA" type="num" xsi:type="element" />
            -      <Parameter name="x_sB" type="string" xsi:type="element" />
            +      <Parameter name="x_nA" type="num" xsi:type="element" use="reference" />
            +      <Parameter name="x_sB" type="num" xsi:type="element" />
        "#]],
    );
    check(
        "program pick(num& x_nA[,])\nbegin\n  $0put(1)\nend",
        |wanted| {
            wanted.parameters[0].container = Container::Element;
            wanted.parameters[0].by_reference = false;
        },
        expect![[r#"
            usrapp/main/pick.pgx
            -      <Parameter name="x_nA" type="num" xsi:type="array" use="reference" dimensions="2" />
            +      <Parameter name="x_nA" type="num" xsi:type="element" />
        "#]],
    );
}

const SHARED: &str = "library part \"Disk://part/part.pjx\" autoload=false\nnum nA\nnA=part:libLoad(\"Disk://box\")\n\
    call part:pick(1,2)\n--- part\npublic program pick(num x_nA,num x_nB)\nbegin\n  $0put(x_nA)\nend\n\
    --- box\npublic program pick(num x_nA,num x_nOther)\nbegin\n  put(x_nA)\nend";

#[test]
fn libraries_of_an_interface_follow() {
    check(
        SHARED,
        |wanted| {
            wanted.parameters.swap(0, 1);
            wanted.parameters[0].name = "x_nC".to_owned();
            wanted.parameters[1].name = "x_nD".to_owned();
        },
        expect![[r#"
            usrapp/box/pick.pgx
            -      <Parameter name="x_nA" type="num" xsi:type="element" />
            -      <Parameter name="x_nOther" type="num" xsi:type="element" />
            -    </Parameters>
            -    <Code><![CDATA[begin
            -  put(x_nA)
            +      <Parameter name="x_nOther" type="num" xsi:type="element" />
            +      <Parameter name="x_nD" type="num" xsi:type="element" />
            +    </Parameters>
            +    <Code><![CDATA[begin
            +  put(x_nD)
            usrapp/main/start.pgx
            -call part:pick(1,2)
            +call part:pick(2,1)
            usrapp/part/pick.pgx
            -      <Parameter name="x_nA" type="num" xsi:type="element" />
            -      <Parameter name="x_nB" type="num" xsi:type="element" />
            -    </Parameters>
            -    <Code><![CDATA[begin
            -  put(x_nA)
            +      <Parameter name="x_nC" type="num" xsi:type="element" />
            +      <Parameter name="x_nD" type="num" xsi:type="element" />
            +    </Parameters>
            +    <Code><![CDATA[begin
            +  put(x_nD)
        "#]],
    );
    check(
        SHARED,
        |wanted| drop(wanted.parameters.remove(1)),
        expect![[r#"
        usrapp/box/pick.pgx
        -      <Parameter name="x_nOther" type="num" xsi:type="element" />
        usrapp/main/start.pgx
        -call part:pick(1,2)
        +call part:pick(1)
        usrapp/part/pick.pgx
        -      <Parameter name="x_nB" type="num" xsi:type="element" />
    "#]],
    );
    let used = SHARED.replace("  put(x_nA)\nend\n--- box", "  put(1)\nend\n--- box");
    check(
        &used,
        |wanted| drop(wanted.parameters.remove(0)),
        expect![[r#"
        refused: the parameter `x_nA` is used once in `pick`
    "#]],
    );
    let other = SHARED.replace("num x_nOther", "num x_nOther,num x_nMore");
    check(
        &other,
        |wanted| wanted.parameters.swap(0, 1),
        expect![[r#"
        refused: `box` has the program `pick` for the same interface, and its parameters are others or cannot be read
    "#]],
    );
}

#[test]
fn private_programs_of_the_same_name_are_others() {
    let private = SHARED.replace("--- box\npublic", "--- box\nprivate");
    let done = done(&private, |wanted| wanted.parameters.swap(0, 1));
    assert!(done.contains("call part:pick(2,1)") && !done.contains("box"), "{done}");
}

const OLD: &str = "num nZ\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\"><program name=\"start\" public=\"false\"><paramSection/><localSection /><source><code>begin\n  call other(1&lt;2)\nend</code></source></program></programList>\n\
    === main/other.pgx\n<programList xmlns=\"ProgramNameSpace\">\n  <program name=\"other\" public=\"false\">\n    <paramSection><param name=\"x_b\" type=\"bool\" byVal=\"true\" /></paramSection>\n    <localSection />\n    <source><code>begin\n  $0put(&quot;&quot;)\nend</code></source>\n  </program>\n</programList>\n";

#[test]
fn programs_of_s6_change() {
    check(
        OLD,
        |wanted| {
            wanted.parameters.insert(0, added("x_s", "string", "\"<\""));
            wanted.parameters[1].by_reference = true;
            wanted.locals.push(local("l_n", "num", &[3]));
        },
        expect![[r#"
            usrapp/main/other.pgx
            -    <paramSection><param name="x_b" type="bool" byVal="true" /></paramSection>
            -    <localSection />
            +    <paramSection><param name="x_s" type="string" byVal="true" /><param name="x_b" type="bool" byVal="false" /></paramSection>
            +    <localSection >
            +      <local name="l_n" type="num" size="3" />
            +    </localSection>
            usrapp/main/start.pgx
            -  call other(1&lt;2)
            +  call other(&quot;&lt;&quot;,1&lt;2)
        "#]],
    );
    check(
        OLD,
        |wanted| wanted.parameters.clear(),
        expect![[r#"
        usrapp/main/other.pgx
        -    <paramSection><param name="x_b" type="bool" byVal="true" /></paramSection>
        +    <paramSection/>
        usrapp/main/start.pgx
        -  call other(1&lt;2)
        +  call other()
    "#]],
    );
    check(
        OLD,
        |wanted| {
            wanted.parameters[0].container = Container::Array { dims: 2 };
            wanted.parameters[0].by_reference = true;
        },
        expect![[r#"
        refused: programs of s5 and s6 have no collections and arrays of one dimension, and so has `x_b`
    "#]],
    );
}

const LOCALS: &str = "program other()\n  num l_nA\n  string l_sB\n  num l_nC\nbegin\n  $0l_nA=1\nend";

#[test]
fn locals_change() {
    check(
        LOCALS,
        |wanted| {
            wanted.locals.swap(0, 2);
            wanted.locals[2].name = "l_nD".to_owned();
            wanted.locals[0].sizes = vec![2, 3];
            wanted.locals[1].type_name = "num".to_owned();
        },
        expect![[r#"
            usrapp/main/other.pgx
            -      <Local name="l_nA" type="num" xsi:type="array" size="1" />
            -      <Local name="l_sB" type="string" xsi:type="array" size="1" />
            -      <Local name="l_nC" type="num" xsi:type="array" size="1" />
            -    </Locals>
            -    <Code><![CDATA[begin
            -  l_nA=1
            +      <Local name="l_nC" type="num" xsi:type="array" size="2 3" />
            +      <Local name="l_sB" type="num" xsi:type="array" size="1" />
            +      <Local name="l_nD" type="num" xsi:type="array" size="1" />
            +    </Locals>
            +    <Code><![CDATA[begin
            +  l_nD=1
        "#]],
    );
    check(
        LOCALS,
        |wanted| drop(wanted.locals.remove(1)),
        expect![[r#"
        usrapp/main/other.pgx
        -      <Local name="l_sB" type="string" xsi:type="array" size="1" />
    "#]],
    );
    check(
        LOCALS,
        |wanted| wanted.locals.insert(0, local("l_bE", "bool", &[1])),
        expect![[r#"
        usrapp/main/other.pgx
        +      <Local name="l_bE" type="bool" xsi:type="array" size="1" />
    "#]],
    );
    check(
        LOCALS,
        |wanted| drop(wanted.locals.remove(0)),
        expect![[r#"
        refused: the local variable `l_nA` is used once in `other`
    "#]],
    );
}

#[test]
fn names_and_types_that_do_not_suit_are_refused() {
    let listing = "num nA\npublic num nB\nnA=nB\nprogram other(num x_nA)\n  num l_nC\nbegin\n  $0nA=x_nA+z\nend";
    let refused = |change: &dyn Fn(&mut NewVariables)| done(listing, change);
    let renamed = |name: &str| refused(&|wanted: &mut NewVariables| wanted.parameters[0].name = name.to_owned());
    let retyped = |name: &str| refused(&|wanted: &mut NewVariables| wanted.locals[0].type_name = name.to_owned());
    let resized = |sizes: &[u32]| refused(&|wanted: &mut NewVariables| wanted.locals[0].sizes = sizes.to_vec());
    let passed = |text: &str| refused(&|new: &mut NewVariables| new.parameters.push(added("x_nB", "num", text)));
    let all = [
        renamed("l_nC"),
        renamed("nA"),
        renamed("start"),
        renamed("1a"),
        renamed("endIf"),
        renamed("z"),
        retyped("number"),
        resized(&[]),
        resized(&[0]),
        resized(&[1, 2, 3, 4]),
        passed(""),
        passed("1,2"),
        passed("1) call p("),
        passed("1 // one"),
    ];
    expect![[r#"
        refused: two variables of the program would be called `l_nC`
        refused: the program uses the global `nA`, which the new name would hide
        refused: there is already a program called `start`
        refused: `1a` is no name: letters, digits and `_`, no digit first
        refused: `endIf` is a word of the language
        refused: the program `other` uses the name `z`, which is unresolved
        refused: there is no type `number`
        refused: `l_nC` has one to three dimensions, each with at least one value
        refused: `l_nC` has one to three dimensions, each with at least one value
        refused: `l_nC` has one to three dimensions, each with at least one value
        refused: calls need an expression to pass for the new parameter `x_nB`
        refused: `1,2` is no expression
        refused: `1) call p(` is no expression
        refused: `1 // one` is no expression
    "#]]
    .assert_eq(&all.concat());
    // Data that the program does not use may be hidden.
    assert!(renamed("nB").contains("+"));
}

#[test]
fn calls_that_cannot_follow_are_refused() {
    let cell = |line| format!("num nA\nstring sA\n{line}\nprogram other(num x_nA,num x_nB)\nbegin\n  $0put(1)\nend");
    let swapped = |line| done(&cell(line), |wanted: &mut NewVariables| wanted.parameters.swap(0, 1));
    let removed = |line| done(&cell(line), |wanted: &mut NewVariables| drop(wanted.parameters.remove(0)));
    let all = [
        swapped("call other(1)"),
        swapped("call other(1,2"),
        swapped("call other(get(),1)"),
        removed("call other(get(),1)"),
        removed("call other(zUnknown(),1)"),
    ];
    expect![[r#"
        refused: a call in `start` passes 1 arguments instead of 2
        refused: `start.pgx` may call `other` and has syntax errors
        refused: the argument `get()` of a call in `start` has an effect, so the order of its arguments matters
        refused: the argument `get()` of a call in `start` has an effect
        refused: the argument `zUnknown()` of a call in `start` has an effect
    "#]]
    .assert_eq(&all.concat());
    assert!(removed("call other(abs(nA),1)").contains("+call other(1)"));
}

#[test]
fn unknown_libraries_are_refused() {
    check(
        "library part \"Disk://part/part.pjx\"\ncall part:pick(1)\n--- box\npublic program pick(num x_nA)\nbegin\n  $0put(1)\nend",
        |wanted| wanted.parameters.clear(),
        expect![[r#"
            refused: `start` calls `part:pick`, and the library `part` cannot be resolved
        "#]],
    );
}

#[test]
fn programs_that_the_system_calls_keep_their_parameters() {
    let add = |wanted: &mut NewVariables| wanted.parameters.push(added("x_nA", "num", "1"));
    check(
        "$0put(1)",
        add,
        expect![[r#"
        refused: the controller itself calls `start`, without arguments
    "#]],
    );
    check(
        "$0put(1)",
        |wanted| wanted.locals.push(local("l_nA", "num", &[1])),
        expect![[r#"
        usrapp/main/start.pgx
        +    <Locals>
        +      <Local name="l_nA" type="num" xsi:type="array" size="1" />
        +    </Locals>
    "#]],
    );
    check(
        "put(1)\n--- mainTest\nprogram testSum()\nbegin\n  $0put(1)\nend",
        add,
        expect![[r#"
            refused: `val3 test` calls `testSum`, with the number of a row as the only possible argument
        "#]],
    );
}

#[test]
fn broken_programs_are_left_alone() {
    let broken = "program other(num x_nA)\n  num l_nB\nbegin\n  $0put(x_nA\nend";
    check(
        broken,
        |wanted| wanted.parameters[0].name = "x_nC".to_owned(),
        expect![[r#"
        refused: `other.pgx` has syntax errors, so some uses of its variables may be missing
    "#]],
    );
    check(
        broken,
        |wanted| wanted.locals.clear(),
        expect![[r#"
        refused: `other.pgx` has syntax errors, so some uses of its variables may be missing
    "#]],
    );
    // A new local does not depend on the code.
    check(
        broken,
        |wanted| wanted.locals.push(local("l_nC", "num", &[1])),
        expect![[r#"
        usrapp/main/other.pgx
        +      <Local name="l_nC" type="num" xsi:type="array" size="1" />
    "#]],
    );
}

#[test]
fn indexes_of_another_time_are_refused() {
    check(
        PICK,
        |wanted| wanted.parameters[0].from = Some(7),
        expect![[r#"
        refused: the program was changed meanwhile
    "#]],
    );
    check(
        PICK,
        |wanted| wanted.parameters[0].from = Some(1),
        expect![[r#"
        refused: the program was changed meanwhile
    "#]],
    );
}
