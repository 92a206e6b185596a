//! Memory of calls and tasks: error 40, and the release of memory.

use crate::host::Bench;

const MEGABYTE: u64 = 1 << 20;

/// Returns the record when the application begins with this much free memory.
#[track_caller]
fn record(text: &str, bytes: u64) -> String {
    let mut bench = Bench::new(text);
    let room = &mut bench.vm.space.memory.stores.room;
    room.limit_to(room.taken() + bytes);
    bench.run().host.record
}

#[test]
fn calls_without_end_use_up_the_memory() {
    let text =
        "stack 4000000000\nprogram start\nlocal l_nA num[] c0\ncontainer num[50]\nline 4 Call start ()\nReturn\nend";
    assert_eq!(record(text, MEGABYTE), "error 40 at row 4\n");
}

#[test]
fn calls_of_programs_without_data_use_up_the_memory() {
    let text = "stack 4000000000\nprogram start\nline 4 Call start ()\nReturn\nend";
    assert_eq!(record(text, MEGABYTE), "error 40 at row 4\n");
}

#[test]
fn tasks_without_end_use_up_the_memory() {
    let text = r#"
version s8.10
program sleep
    frame n1
    nums n0=100
    line 11 Instruction delay (num n0)
    Return
end
program start
    frame n1/t1
    nums n0=10
again:
    line 1 Concatenate t0 t0 "x"
    line 2 CreateTask t0 n0 sleep ()
    line 3 Jump again
end"#;
    assert_eq!(record(text, MEGABYTE), "error 40 at row 2\n");
}

#[test]
fn a_task_that_ends_gives_its_memory_back() {
    let text = r#"
program deep
    param x_nLeft num n0
    frame n3
    nums n1=1
    container num[10]
    line 11 StoreElement c0 n1 n0
    line 12 UnlessLess n2 n0 done
    line 13 Subtract n0 n0 n1 Call deep (num n0)
done:
    Return
end
program start
    frame n6/t1
    nums n0=1, n1=1, n2=500, n3=1, n4=20, n5=0.01
    line 1 ForTest n0 n2 done
again:
    line 2 CreateTask "deep" n1 deep (num n4)
    line 3 Instruction delay (num n5)
    ForNextUp n0 n2 again
done:
    line 5 TextMove t0 "done" Instruction print (string t0)
    Return
end"#;
    assert_eq!(record(text, MEGABYTE / 2), "done\n");
}
