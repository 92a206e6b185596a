//! The machine that runs machine code: a WebAssembly engine, which keeps it within its memory.

use std::collections::BTreeSet;
use std::fmt;

use rustc_hash::FxHashMap;
use val3_bytecode::Image;
use wasmtime::error::Context as _;
use wasmtime::{Config, Engine, Func, Instance, Memory, Module, Store, TypedFunc};

use crate::body::Surroundings;
use crate::containers::Shared;
use crate::counting::write_numbers;
use crate::effort;
use crate::fill::Fill;
use crate::functions::compute;
use crate::module::{MEMORY, Plan};
use crate::operands::located;
use crate::operations::has_code;
use crate::study::Study;
use crate::ways::name;

/// What a function is given: see [`local`](crate::local). Where it is entered again, no numbers.
pub(crate) type Given = (u32, u32, u32, u32, f64, f64, f64, f64);

/// The function of a program: where its frame is and where to begin; whether it has stopped, and the lines left.
pub(crate) type Entry = TypedFunc<Given, (u32, u32)>;

/// The engine with all modules.
pub(crate) struct Machinery {
    store: Store<()>,
}

/// A module, ready to run.
pub(crate) struct Compiled {
    pub(crate) shared: Shared,
    /// Lines that a stretch may execute, so that others outside can look.
    pub(crate) most_lines: u32,
    memory: Memory,
    programs: FxHashMap<u16, Entrance>,
}

/// How a program is entered.
struct Entrance {
    entry: Entry,
    study: Study,
    /// The places that machine code looks up.
    located: BTreeSet<u32>,
}

impl Machinery {
    /// An engine without modules.
    pub(crate) fn new() -> wasmtime::Result<Self> {
        let engine = Engine::new(&Config::new())?;
        Ok(Self { store: Store::new(&engine, ()) })
    }

    /// Compiles the programs of a plan.
    pub(crate) fn compile(&mut self, plan: Plan, image: &Image) -> wasmtime::Result<Compiled> {
        let encoded = plan.encode(image).context("a program is not there")?;
        let module = Module::new(self.store.engine(), encoded)?;
        let compute = Func::wrap(&mut self.store, compute);
        let instance = Instance::new(&mut self.store, &module, &[compute.into()])?;
        let memory = instance.get_memory(&mut self.store, MEMORY).context("no memory")?;
        write_numbers(memory.data_mut(&mut self.store)).context("no room for numbers")?;
        let mut programs = FxHashMap::default();
        let module = Surroundings { image, programs: &plan.programs, shared: &plan.shared };
        for number in &plan.programs {
            let entry = instance.get_typed_func(&mut self.store, &Plan::name(*number))?;
            if let Some(program) = image.programs.get(usize::from(*number)) {
                let ops = program.code.iter().map(|step| step.op).filter(|op| has_code(&module, program, *op));
                let located = ops.filter_map(located).map(|(place, _)| place.into()).collect();
                let study = Study::of(&module, program, 0);
                programs.insert(*number, Entrance { entry, study, located });
            }
        }
        let most_lines = effort::most_lines(plan.steps(image));
        Ok(Compiled { shared: plan.shared, most_lines, memory, programs })
    }

    /// The memory of a module.
    pub(crate) fn bytes(&mut self, code: &Compiled) -> &mut [u8] {
        code.memory.data_mut(&mut self.store)
    }

    /// Runs a program.
    pub(crate) fn call(&mut self, entry: &Entry, given: Given) -> wasmtime::Result<(u32, u32)> {
        entry.call(&mut self.store, given)
    }
}

impl Compiled {
    /// The function of a program and how it is told to begin at a step; `None` where it cannot.
    pub(crate) fn entry(&self, program: u16, step: u32) -> Option<(&Entry, u32)> {
        let Entrance { entry, study, .. } = self.programs.get(&program)?;
        study.regions.entries().contains(&step).then_some((entry, name(step)))
    }

    /// The places of a program that machine code looks up.
    pub(crate) fn located(&self, program: u16) -> impl Iterator<Item = u32> {
        self.programs.get(&program).into_iter().flat_map(|entrance| entrance.located.iter().copied())
    }

    /// The loop with this head, if it fills an array.
    pub(crate) fn fill(&self, program: u16, head: u32) -> Option<&Fill> {
        self.programs.get(&program)?.study.fills.get(&head)
    }

    /// Whether a program can be entered with these numbers in its frame.
    pub(crate) fn takes(&self, program: u16, numbers: &[f64]) -> bool {
        self.programs.get(&program).is_some_and(|entrance| entrance.study.suits(numbers))
    }
}

impl fmt::Debug for Compiled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Compiled").field("programs", &self.programs.keys()).finish_non_exhaustive()
    }
}

impl fmt::Debug for Machinery {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Machinery").finish_non_exhaustive()
    }
}
