//! Programs that need more memory than a controller has (error 40), and the release of memory.

use std::sync::Arc;

use val3_bytecode::Image;
use val3_compile::CompileLimit;
use val3_lang::memory::MEMORY;
use val3_machine::controller::{Controller, RunStatus};
use val3_machine::event::EventKind;

use crate::execution::{LINE_COST, started};
use crate::show::{image, project, workspace};

const MEGABYTE: u64 = 1 << 20;

/// Creates a controller with `bytes` of free memory after the start of the application.
fn with_memory(image: Image, bytes: u64) -> Controller {
    let mut controller = started(&Arc::new(image), LINE_COST);
    let taken = controller.vm.space.memory.stores.room.taken();
    controller.vm.space.memory.stores.room.limit_to(taken + bytes);
    controller
}

/// Runs the application until it has ended or is stuck, and returns its output and its tasks' errors.
fn run(controller: &mut Controller) -> String {
    let mut shown = String::new();
    loop {
        let step = controller.step();
        for event in controller.devices.take_events() {
            match event.kind {
                EventKind::Print { text } => shown += &format!("{text}\n"),
                EventKind::Error { code, line, .. } => shown += &format!("error {code} in line {line}\n"),
                _ => {}
            }
        }
        match step {
            status if status.is_final() => return shown,
            RunStatus::Waiting(Some(wake)) => controller.jump(wake),
            _ => {}
        }
    }
}

/// Checks that the application fails with error 40 in some line, within a megabyte.
#[track_caller]
fn fails(listing: &str) {
    let printed = run(&mut with_memory(image(listing), MEGABYTE));
    assert!(printed.contains("error 40 in line"), "{printed}");
}

#[test]
fn all_variables_share_the_memory() {
    fails(
        "
        version s8.10
        num nA[1]
        num nB[1]
        string sC[1]
        program start()
        begin
          resize(nA,1,50000)
          resize(nB,1,50000)
          resize(sC,1,3000)
        end",
    );
}

#[test]
fn what_grows_without_end() {
    for (declared, grows) in [
        ("num nA[1]", "append(nA)"),
        ("point pA[1]", "insert(pA[0])"),
        ("num nA[\"\"]", "insert(nA[toString(\"\",n)])"),
        ("dio dA[\"\"]", "insert(dA[toString(\"\",n)])"),
    ] {
        fails(&format!(
            "
            version s8.10
            {declared}
            num n
            program start()
            begin
              while true
                {grows}
                n=n+1
              endWhile
            end"
        ));
    }
}

const SLOTS: &str = r#"
version s8.10
type Slot "slot/slot.pjx"
Slot tSlots[1]
Slot tOther
num n
"#;

const SLOT: &str = r#"
--- slot
public num nValues[100]
public string sNames[""]
"#;

#[test]
fn values_of_user_types() {
    for grows in ["append(tSlots)", "resize(tSlots,1,1+20*n)", "resize(tOther.nValues,1,1+20000*n)"] {
        fails(&format!("{SLOTS}program start()\nbegin\nwhile true\n{grows}\nn=n+1\nendWhile\nend{SLOT}"));
    }
}

#[test]
fn a_copy_that_does_not_fit() {
    fails(&format!(
        "{SLOTS}program start()\nbegin\nresize(tSlots,1,2)\nresize(tSlots[0].nValues,1,60000)\n\
         tSlots[1]=tSlots[0]\n? size(tSlots[1].nValues)\ntOther=tSlots[0]\nend{SLOT}"
    ));
}

#[test]
fn what_fails_leaves_everything_as_it_was() {
    let mut controller = with_memory(
        image(&format!(
            "{SLOTS}
            program fill()
            begin
              while true
                append(tSlots)
              endWhile
            end
            program start()
            begin
              taskCreate \"fill\",10,fill()
              wait(taskStatus(\"fill\")==40)
              n=size(tSlots)
              ? n>100
              resize(tSlots,1,1)
              ? size(tSlots)
              resize(tSlots,1,n)
              ? size(tSlots)-n
              ? size(tSlots[n-1].nValues)
              resize(tSlots,1,1)
            end{SLOT}"
        )),
        MEGABYTE,
    );
    let taken = controller.vm.space.memory.stores.room.taken();
    let printed = run(&mut controller);
    let printed: Vec<_> = printed.lines().skip(1).collect();
    assert_eq!(printed, ["true", "1", "0", "100"]);
    let left = controller.vm.space.memory.stores.room.taken();
    assert!(left < taken, "{left} {taken}: the task of `start` is gone");
}

#[test]
fn a_call_that_fails_can_be_repeated() {
    let program = "
        num nA[1]
        program work(num nX)
          num l_nA[20000]
          num l_nB[50000]
        begin
          l_nA[1]=nX
          l_nB[1]=l_nA[1]
          ? l_nB[1]
        end
        program calls()
        begin
          call work(3)
        end
        program start()
        begin
          resize(nA,1,9999)
          resize(nA,1,9999)
          taskCreate \"calls\",10,calls()
          wait(taskStatus(\"calls\")==40)
          resize(nA,1,1)
          taskResume(\"calls\",0)
          wait(taskStatus(\"calls\")==-1)
        end";
    let mut large = image(program);
    large.stack_size = u32::MAX;
    let printed = run(&mut with_memory(large, 700_000));
    assert!(printed.starts_with("error 40") && printed.ends_with("\n3\n"), "{printed}");
}

#[test]
fn local_screens_take_memory() {
    fails(
        "
        version s8.10
        program show()
          screen l_scPage
        begin
          cls(l_scPage)
        end
        program start()
        begin
          while true
            call show()
          endWhile
        end",
    );
}

/// The sizes in files are checked before values are created.
#[test]
fn data_beyond_all_memory_are_refused() {
    for data in [
        "num nHuge[4000000000]",
        "num nGrid[65536,65536]",
        "mdesc mHuge[100000000]",
        "num nA[50000000]\nnum nB[50000000]",
    ] {
        let workspace = workspace(&format!("version s8.10\n{data}\nprogram start()\nbegin\nend"));
        let refused = val3_compile::compile(&workspace.db, project(&workspace, "main"));
        let error = refused.map(drop).unwrap_err();
        assert_eq!(error.limit, CompileLimit::Memory, "{data}");
        let last = data.lines().last().unwrap();
        let name = last.split([' ', '[']).nth(1).map(str::to_owned);
        assert_eq!(error.variable, name, "{data}");
        assert!(error.file.ends_with("main.dtx") && error.row > 1, "{error}");
    }
}

#[test]
fn a_large_grid_fits() {
    let large = image("version s8.10\nnum nGrid[4000,4000]\nprogram start()\nbegin\n? size(nGrid,2)\nend");
    let mut controller = started(&Arc::new(large), LINE_COST);
    assert!(controller.vm.space.memory.stores.room.taken() < MEMORY);
    assert_eq!(run(&mut controller), "4000\n");
}
