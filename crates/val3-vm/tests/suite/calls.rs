//! Program calls and their parameters (2.6), and the stack (2.1.4.2).

use expect_test::expect;
use val3_lang::fault::Fault;
use val3_vm::{ProgramId, Vm};

use crate::host::{Host, check, image_of};

#[test]
fn a_program_returns_to_the_operation_after_its_call() {
    check(
        r#"
program inner
    frame n1
    nums n0=1
    line 11 Instruction print (num n0)
    Return
end
program outer
    frame n1
    nums n0=2
    line 21 Call inner ()
    line 22 Instruction print (num n0)
    Return
end
program start
    frame n1
    nums n0=3
    line 1 Call outer ()
    line 2 Instruction print (num n0)
    Return
end"#,
        expect![[r#"
            1
            2
            3
        "#]],
    );
}

#[test]
fn each_call_has_a_new_frame() {
    check(
        r#"
program count
    local l_nCount num n0
    frame n2
    nums n0=5, n1=1
    line 11 Add n0 n0 n1
    line 12 Instruction print (num n0)
    Return
end
program start
    line 1 Call count ()
    line 2 Call count ()
    Return
end"#,
        expect![[r#"
            6
            6
        "#]],
    );
}

#[test]
fn a_parameter_by_value_is_a_copy() {
    check(
        r#"
program change
    param x_nValue num n0
    param x_sText string t0
    param x_trValue trsf n1
    frame n8/t1
    nums n7=9
    line 11 Move n0 n7
    line 12 TextMove t0 "changed"
    line 13 Move n1 n7
    Return
end
program start
    frame n7/t1
    nums n0=1, n1=2
    line 1 TextMove t0 "own"
    line 2 Call change (num n0, string t0, trsf n1)
    line 3 Instruction print (num n0)
    line 4 Instruction print (string t0)
    line 5 Instruction print (trsf n1)
    Return
end"#,
        expect![[r#"
            1
            own
            {2,0,0,0,0,0}
        "#]],
    );
}

#[test]
fn a_parameter_by_reference_changes_the_variable_of_the_caller() {
    check(
        r#"
data nData num[3] {1, 2, 3}
program change
    param x_nValue num p0
    param x_sText string p1
    frame n1/p2
    nums n0=9
    line 11 Store p0 0 n0
    line 12 TextMove p1 "changed"
    Return
end
program start
    frame n2/t1/p1
    nums n1=2
    line 1 Call change (num n0, string t0)
    line 2 Instruction print (num n0)
    line 3 Instruction print (string t0)
    line 4 Locate p0 $nData n1 Call change (num p0, string t0)
    line 5 LoadElement n0 $nData n1 Instruction print (num n0)
    Return
end"#,
        expect![[r#"
            9
            changed
            9
        "#]],
    );
}

#[test]
fn a_reference_can_be_passed_on() {
    check(
        r#"
program inner
    param x_nValue num p0
    frame n1/p1
    nums n0=9
    line 11 Store p0 0 n0
    Return
end
program outer
    param x_nValue num p0
    frame p1
    line 21 Call inner (num p0)
    Return
end
program start
    frame n1
    line 1 Call outer (num n0)
    line 2 Instruction print (num n0)
    Return
end"#,
        expect![[r#"
            9
        "#]],
    );
}

#[test]
fn an_array_by_reference_can_begin_at_an_index() {
    check(
        r#"
data nData num[4] {1, 2, 3, 4}
program change
    param x_nValues num[] v0
    frame n3/v1
    nums n1=9, n2=1
    line 11 StoreElement v0 n2 n1
    line 12 Instruction size (view v0) -> num n0 Instruction print (num n0)
    Return
end
program start
    frame n3
    nums n0=2, n1=3
    line 1 Call change (view $nData from n0)
    line 2 LoadElement n2 $nData n1 Instruction print (num n2)
    line 3 Call change (view $nData)
    Return
end"#,
        expect![[r#"
            2
            9
            4
        "#]],
    );
}

#[test]
fn an_array_has_no_values_beyond_its_end_when_it_begins_at_an_index() {
    check(
        r#"
data nData num[4]
program change
    param x_nValues num[] v0
    frame n2/v1
    nums n1=2
    line 11 StoreElement v0 n1 n0
    Return
end
program start
    frame n1
    nums n0=2
    line 1 Call change (view $nData from n0)
    Return
end"#,
        expect![[r#"
            error 20 at row 11
        "#]],
    );
}

#[test]
fn a_user_type_by_value_is_a_copy_with_its_containers() {
    check(
        r#"
type Slot {
    nCount num[1] {7}
    sNames string["a"] {"x"}
}
data tSlot @Slot[1]
program change
    param x_tSlot @Slot c0
    frame n1/v1
    nums n0=9
    container @Slot[1]
    line 11 FirstField v0 c0 0 StoreFirst v0 0 n0
    line 12 FirstField v0 c0 1 LocateKey p0 v0 "a" TextMove p0 "changed"
    Return
end
program start
    line 1 Call change (user $tSlot)
    line 2 Instruction print (user $tSlot)
    Return
end"#
            .replace("frame n1/v1", "frame n1/p1/v1")
            .as_str(),
        expect![[r#"
            {7,"x"}
        "#]],
    );
}

#[test]
fn calls_without_end_fill_the_stack_of_the_task() {
    check(
        r#"
stack 1000
data nDepth num[1]
program deeper
    stack 100
    frame n2
    nums n1=1
    line 11 LoadFirst n0 $nDepth 0 Add n0 n0 n1 StoreFirst $nDepth 0 n0
    line 12 Call deeper ()
    Return
end
program start
    frame n2/t1
    nums n0=10, n1=1
    line 1 CreateTask "deep" n0 deeper ()
    line 2 Instruction delay (num n1)
    line 3 Instruction print (num $nDepth)
    Return
end"#,
        expect![[r#"
            error 41 at row 12
            10
        "#]],
    );
}

/// The stack contains the locals of the first program, too (2.1.4.2).
#[test]
fn a_task_whose_first_program_exceeds_the_stack_is_not_created() {
    check(
        r#"
stack 1000
program large
    stack 1001
    Return
end
program start
    frame n1
    nums n0=10
    line 1 CreateTask "large" n0 large ()
    Return
end"#,
        expect![[r#"
            error 41 at row 1
        "#]],
    );
}

#[test]
fn a_program_that_exceeds_the_stack_does_not_start() {
    let image = image_of("stack 1000\nprogram start\nstack 1001\nReturn\nend");
    let (mut vm, mut host) = (Vm::default(), Host::default());
    let application = vm.space.load(image, String::new(), &mut host).unwrap();
    let program = ProgramId { instance: application, number: 0 };
    assert_eq!(vm.start("start", program, 10, &mut host), Err(Fault::STACK_FULL));
    assert!(vm.tasks().is_empty());
}
