//! Stack of a task: error 41 (2.1.4.2).

use expect_test::expect;
use val3_tests::running::Running;

use crate::execution::check;

#[test]
fn a_recursion_without_end_fills_the_stack_of_its_task_alone() {
    check(
        r#"
        num nDepth
        program deeper()
        begin
          nDepth=nDepth+1
          call deeper()
        end
        program start()
        begin
          taskCreate "deep",100,deeper()
          wait(taskStatus("deep")!=1)
          ? taskStatus("deep")
          ? nDepth>10 and nDepth<5000
          taskKill("deep")
        end
        "#,
        expect![[r#"
            error 41
            41
            true
        "#]],
    );
}

#[test]
fn locals_fill_the_stack() {
    check(
        r#"
        program large()
          num l_nArray[9000]
        begin
          ? "never"
        end
        program small()
          num l_nArray[100]
        begin
          ? size(l_nArray)
        end
        program both()
        begin
          call small()
          call large()
        end
        program start()
        begin
          taskCreate "both",10,both()
          wait(taskStatus("both")!=1)
          ? taskStatus("both")
          taskKill("both")
        end
        "#,
        expect![[r#"
            100
            error 41
            41
        "#]],
    );
}

/// Returns the depth of calls that a stack of this size allows.
fn depth(bytes: u32) -> u32 {
    let listing = format!(
        r#"
num nDepth
program deeper()
begin
  nDepth=nDepth+1
  call deeper()
end
program start()
begin
  taskCreate "deep",100,deeper()
  wait(taskStatus("deep")!=1)
  ? nDepth
  taskKill("deep")
end
=== main/main.pjx
<?xml version="1.0" encoding="utf-8" ?>
<Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
  <Parameters version="s7.11" stackSize="{bytes}" millimeterUnit="true" />
  <Programs><Program file="start.pgx" /><Program file="deeper.pgx" /></Programs>
  <Database><Data file="main.dtx" /></Database>
  <Libraries />
</Project>
"#
    );
    let printed = Running::start(&listing).to_the_end().printed();
    printed.lines().last().unwrap().parse().unwrap()
}

#[test]
fn a_larger_stack_holds_more_calls() {
    let (small, large) = (depth(5000), depth(10000));
    assert!(small > 10 && (large == 2 * small || large == 2 * small + 1), "{small} {large}");
}
