//! Control-flow graph: all nodes of a program and their edges.

use std::collections::BTreeSet;

use expect_test::{Expect, expect};
use val3_analysis::flow::{Facts, FlowGraph, FlowNode, FlowNodeId, PointKind, backward, flow, forward};

use crate::show::{program, project, workspace};

/// Shows the flow nodes of the program `start`: index, operation, first line, and successors. An unreachable node is
/// marked `!`.
fn check(code: &str, expected: Expect) {
    let workspace = workspace(&format!("num n\nbool b\n\n{code}"));
    let db = &workspace.db;
    let file = program(db, project(&workspace, "main"), "start");
    let flow = flow(db, file);
    let reached = flow.reachable(|_, _| true);
    let shown: String = flow
        .points()
        .map(|(id, point)| {
            let text = file.text(db)[point.range].lines().next().unwrap_or("");
            let next: String = point.next.iter().map(|next| format!(" {}", next.index())).collect();
            let mark = if reached[id.index()] { "" } else { " !" };
            format!("{} {}{mark} `{text}` ->{next}\n", id.index(), name(point))
        })
        .collect();
    assert_eq!(flow.len(), reached.len());
    expected.assert_eq(&shown);
}

fn name(point: &FlowNode) -> &'static str {
    match point.kind {
        PointKind::Start => "start",
        PointKind::End => "end",
        PointKind::Test { is_loop: false, .. } => "test",
        PointKind::Test { is_loop: true, .. } => "loop",
        PointKind::ForStart { .. } => "for",
        PointKind::ForTest { .. } => "round",
        PointKind::Switch { .. } => "switch",
        PointKind::Return => "return",
        PointKind::Call(_) => "call",
        PointKind::TaskCreate(_) => "task",
        PointKind::Print(_) => "print",
        PointKind::Assign { .. } => "assign",
        PointKind::Expr(_) => "expr",
        PointKind::Empty => "empty",
        PointKind::Unknown => "unknown",
    }
}

#[test]
fn lines_follow_each_other() {
    check(
        "n=1\nput(n)\n?n\ncall stop()\ntaskCreate \"t\",10,stop()\nprogram stop()\nbegin\nend",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 assign `n=1` -> 3
        3 expr `put(n)` -> 4
        4 print `?n` -> 5
        5 call `call stop()` -> 6
        6 task `taskCreate "t",10,stop()` -> 1
    "#]],
    );
    assert!(FlowGraph::default().is_empty());
}

#[test]
fn an_empty_program_has_two_points() {
    check(
        "program start()\nbegin\nend",
        expect![[r#"
        0 start `` -> 1
        1 end `` ->
    "#]],
    );
}

#[test]
fn an_if_has_a_path_for_each_branch() {
    check(
        "if b\n  n=1\nelseIf n==2\n  n=3\nelse\n  n=4\nendIf\nn=5",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 test `b` -> 3 4
        3 assign `n=1` -> 7
        4 test `n==2` -> 5 6
        5 assign `n=3` -> 7
        6 assign `n=4` -> 7
        7 assign `n=5` -> 1
    "#]],
    );
    check(
        "if b\n  n=1\nendIf",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 test `b` -> 3 1
        3 assign `n=1` -> 1
    "#]],
    );
}

#[test]
fn empty_blocks_have_points_of_their_own() {
    check(
        "if b\nelseIf n==2\nelse\nendIf\nn=5",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 test `b` -> 3 4
        3 empty `` -> 6
        4 test `n==2` -> 5 6
        5 empty `` -> 6
        6 assign `n=5` -> 1
    "#]],
    );
    check(
        "while b\nendWhile\nn=5",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 loop `b` -> 2 3
        3 assign `n=5` -> 1
    "#]],
    );
    check(
        "do\nuntil b\nn=5",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 loop `b` -> 3 2
        3 empty `` -> 4
        4 assign `n=5` -> 1
    "#]],
    );
    check(
        "for n=0 to 3\nendFor\nn=5",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 for `for n=0 to 3` -> 3
        3 round `for n=0 to 3` -> 3 4
        4 assign `n=5` -> 1
    "#]],
    );
    check(
        "switch n\n  case 1\n  break\n  default\n  break\nendSwitch\nn=5",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 switch `switch n` -> 3 4
        3 empty `` -> 5
        4 empty `` -> 5
        5 assign `n=5` -> 1
    "#]],
    );
}

#[test]
fn a_switch_without_default_may_be_passed() {
    check(
        "switch n\n  case 1,2\n    n=3\n  break\n  case 4\n    n=5\n  break\nendSwitch\nn=6",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 switch `switch n` -> 3 4 5
        3 assign `n=3` -> 5
        4 assign `n=5` -> 5
        5 assign `n=6` -> 1
    "#]],
    );
}

#[test]
fn nested_loops_repeat_separately() {
    check(
        "while b\n  do\n    for n=0 to 3\n      put(n)\n    endFor\n  until n==4\nendWhile\nn=5",
        expect![[r#"
            0 start `` -> 2
            1 end `` ->
            2 loop `b` -> 3 8
            3 for `for n=0 to 3` -> 4
            4 round `for n=0 to 3` -> 5 6
            5 expr `put(n)` -> 4
            6 loop `n==4` -> 7 3
            7 empty `` -> 2
            8 assign `n=5` -> 1
        "#]],
    );
}

#[test]
fn return_leads_to_the_end() {
    check(
        "if b\n  return\nendIf\nn=1\nreturn\nn=2",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 test `b` -> 3 4
        3 return `return` -> 1
        4 assign `n=1` -> 5
        5 return `return` -> 1
        6 assign ! `n=2` -> 1
    "#]],
    );
    check(
        "while b\n  if n==1\n    return\n  else\n    return\n  endIf\n  n=2\nendWhile",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 loop `b` -> 3 1
        3 test `n==1` -> 4 5
        4 return `return` -> 1
        5 return `return` -> 1
        6 assign ! `n=2` -> 2
    "#]],
    );
    check(
        "do\n  return\nuntil b\nn=1",
        expect![[r#"
        0 start `` -> 2
        1 end `` ->
        2 return `return` -> 1
        3 loop ! `b` -> 4 2
        4 empty ! `` -> 5
        5 assign ! `n=1` -> 1
    "#]],
    );
}

/// Shows the flow nodes with facts, and the numbers in the facts.
fn collected(flow: &FlowGraph, facts: &Facts<BTreeSet<usize>>) -> String {
    let of_point = |(id, _): (FlowNodeId, &FlowNode)| Some(format!("{}: {:?}\n", id.index(), facts.before(id)?));
    flow.points().filter_map(of_point).collect()
}

/// Adds facts to the known facts. Returns whether there are new facts.
fn join(known: &mut BTreeSet<usize>, more: &BTreeSet<usize>) -> bool {
    let before = known.len();
    known.extend(more);
    known.len() > before
}

/// Adds the node to the facts if it is an assignment.
fn with_assignment(id: FlowNodeId, point: &FlowNode, facts: &BTreeSet<usize>) -> BTreeSet<usize> {
    let assigns = matches!(point.kind, PointKind::Assign { .. });
    facts.iter().copied().chain(assigns.then_some(id.index())).collect()
}

#[test]
fn facts_flow_in_both_directions() {
    let workspace = workspace("num n\nbool b\n\nwhile b\n  if b\n    n=1\n  endIf\nendWhile\nreturn\nn=2");
    let db = &workspace.db;
    let flow = flow(db, program(db, project(&workspace, "main"), "start"));
    // Variables assigned before and after a node.
    expect![[r#"
        0: {}
        1: {4}
        2: {4}
        3: {4}
        4: {4}
        5: {4}
    "#]]
    .assert_eq(&collected(flow, &forward(flow, BTreeSet::new(), with_assignment, join)));
    expect![[r#"
        0: {4}
        1: {}
        2: {4}
        3: {4}
        4: {4}
        5: {}
        6: {}
    "#]]
    .assert_eq(&collected(flow, &backward(flow, BTreeSet::new(), with_assignment, join)));
}
