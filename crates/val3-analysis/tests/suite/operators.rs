//! Operators: every pair of types (3.1.2, 3.2.2, 3.4.2, 3.5.2, 3.7.2, 9.2.2 to 9.7.3, 10.5.2).

use expect_test::expect;
use val3_analysis::body::{Expr, StmtKind, body};
use val3_analysis::infer;
use val3_lang::operators::BinaryOp;

use crate::show::{program, project, types, workspace};

const TYPES: [&str; 14] = [
    "bool", "num", "string", "dio", "aio", "sio", "screen", "trsf", "frame", "tool", "point", "joint", "config",
    "mdesc",
];

/// Returns a variable `v_TYPE` for each type.
fn declarations() -> String {
    TYPES.iter().map(|ty| format!("{ty} v_{ty}\n")).collect()
}

/// Shows the lines `? expression` with their types, without invalid expressions.
fn results(expressions: impl Iterator<Item = String>) -> String {
    let lines: String = expressions.map(|expression| format!("? {expression}\n")).collect();
    let workspace = workspace(&(declarations() + &lines));
    let (db, main) = (&workspace.db, project(&workspace, "main"));
    let file = program(db, main, "start");
    let (body, inference) = (body(db, file), infer::infer(db, main, file));
    let mut out = String::new();
    let faulty = infer::problems(db, main, file);
    for stmt in &body.block {
        let StmtKind::Print(id) = stmt.kind else { panic!("{stmt:?}") };
        assert!(!matches!(body.expr(id), Expr::Missing));
        if !faulty.iter().any(|problem| body.range(id).contains_range(problem.place.range)) {
            let text = file.text(db)[body.range(id)].replace("v_", "");
            out += &format!("{text} = {}\n", inference.ty(id).display(db));
        }
    }
    out
}

#[test]
fn every_operator_with_every_pair_of_types() {
    let pairs = TYPES.iter().flat_map(|left| TYPES.iter().map(move |right| (left, right)));
    let expressions = pairs.flat_map(|(left, right)| {
        BinaryOp::ALL.into_iter().rev().map(move |op| format!("v_{left} {} v_{right}", op.symbol()))
    });
    expect![[r#"
        bool == bool = bool
        bool != bool = bool
        bool xor bool = bool
        bool and bool = bool
        bool or bool = bool
        bool == dio = bool
        bool != dio = bool
        bool xor dio = bool
        bool and dio = bool
        bool or dio = bool
        num * num = num
        num / num = num
        num % num = num
        num + num = num
        num - num = num
        num < num = bool
        num <= num = bool
        num > num = bool
        num >= num = bool
        num == num = bool
        num != num = bool
        string + string = string
        string == string = bool
        string != string = bool
        dio == bool = bool
        dio != bool = bool
        dio xor bool = bool
        dio and bool = bool
        dio or bool = bool
        dio == dio = bool
        dio != dio = bool
        dio xor dio = bool
        dio and dio = bool
        dio or dio = bool
        trsf * trsf = trsf
        trsf == trsf = bool
        trsf != trsf = bool
        frame == frame = bool
        frame != frame = bool
        tool == tool = bool
        tool != tool = bool
        point == point = bool
        point != point = bool
        joint + joint = jointRx
        joint - joint = jointRx
        joint < joint = bool
        joint > joint = bool
        joint == joint = bool
        joint != joint = bool
        config == config = bool
        config != config = bool
        mdesc == mdesc = bool
        mdesc != mdesc = bool
    "#]]
    .assert_eq(&results(expressions));
}

#[test]
fn unary_operators() {
    let expressions = TYPES.iter().flat_map(|ty| [format!("-v_{ty}"), format!("!v_{ty}")]);
    expect![[r#"
        !bool = bool
        -num = num
        !dio = bool
        !trsf = trsf
    "#]]
    .assert_eq(&results(expressions));
}

#[test]
fn one_wrong_operand_is_one_fault() {
    let listing = r#"
        num nA
        string sA
        nA=(nA+sA)*2+nA
        nA=-(sA)+1
        nA=nMissing+sA
        if (nA and true) or nA==1
        endIf
    "#;
    expect![[r#"
        nA: num | nA: num | sA: string | nA+sA: ? | (nA+sA): ? | (nA+sA)*2: ? | nA: num | (nA+sA)*2+nA: ?
        nA: num | sA: string | (sA): string | -(sA): ? | -(sA)+1: ?
        nA: num | nMissing: ? | sA: string | nMissing+sA: ?
        nA: num | nA and true: bool | (nA and true): bool | nA: num | nA==1: bool | (nA and true) or nA==1: bool
        ! nA+sA: OperatorType { op: "+", left: Some("num"), right: "string" }
        ! -(sA): OperatorType { op: "-", left: None, right: "string" }
        ! nMissing: UnknownName { name: "nMissing", near: None }
        ! nA and true: OperatorType { op: "and", left: Some("num"), right: "bool" }
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn results_of_unknown_operands() {
    let listing = r#"
        bool bA
        bA=(nMissing==1) and (xMissing<yMissing)
        bA=zMissing+1
    "#;
    expect![[r#"
        bA: bool | nMissing: ? | nMissing==1: bool | (nMissing==1): bool | xMissing: ? | yMissing: ? | xMissing<yMissing: bool | (xMissing<yMissing): bool | (nMissing==1) and (xMissing<yMissing): bool
        bA: bool | zMissing: ? | zMissing+1: ?
        ! nMissing: UnknownName { name: "nMissing", near: None }
        ! xMissing: UnknownName { name: "xMissing", near: None }
        ! yMissing: UnknownName { name: "yMissing", near: None }
        ! zMissing: UnknownName { name: "zMissing", near: None }
    "#]]
    .assert_eq(&types(listing));
}

/// Returns the assignments that have no fault, such as `num=sio`.
fn valid_assignments(lines: impl Iterator<Item = String>) -> Vec<String> {
    let workspace = workspace(&(declarations() + &lines.map(|line| line + "\n").collect::<String>()));
    let (db, main) = (&workspace.db, project(&workspace, "main"));
    let file = program(db, main, "start");
    let (body, faulty) = (body(db, file), infer::problems(db, main, file));
    let ranges = body.block.iter().map(|stmt| match stmt.kind {
        StmtKind::Assign { target, value } => body.range(target).cover(body.range(value)),
        _ => panic!("{stmt:?}"),
    });
    let valid = ranges.filter(|range| !faulty.iter().any(|problem| range.contains_range(problem.place.range)));
    valid.map(|range| file.text(db)[range].replace("v_", "")).collect()
}

/// An assignment is valid as the value of another assignment exactly if a variable of its printed result type is.
#[test]
fn an_assignment_has_its_result_type_as_a_value() {
    let all = || TYPES.iter().flat_map(|target| TYPES.iter().map(move |value| (*target, *value)));
    let pairs = valid_assignments(all().map(|(target, value)| format!("v_{target}=v_{value}")));
    let chains = all().flat_map(|(middle, value)| TYPES.map(|target| format!("v_{target}=v_{middle}=v_{value}")));
    let chains = valid_assignments(chains);
    for (middle, value) in all().filter(|(middle, value)| pairs.contains(&format!("{middle}={value}"))) {
        // 3.5.2 and 3.7.2.
        let result = match middle {
            "dio" => "bool",
            "sio" => value,
            variable => variable,
        };
        for target in TYPES {
            let is_valid = pairs.contains(&format!("{target}={result}"));
            assert_eq!(chains.contains(&format!("{target}={middle}={value}")), is_valid, "{target}={middle}={value}");
        }
    }
}
