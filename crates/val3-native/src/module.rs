//! The programs that call one another as one module of machine code.

use val3_bytecode::{Image, Program, Step};
use wasm_encoder::{
    CodeSection, EntityType, ExportKind, ExportSection, FunctionSection, ImportSection, MemorySection, MemoryType,
    Module, TypeSection,
};

use crate::body::{Surroundings, function};
use crate::calls::{SIGNATURE, plain_call};
use crate::containers::Shared;
use crate::functions::{COMPUTE, FIRST, HOST, is_of_angle};
use crate::layout::{END, PAGE};
use crate::operands::container;
use crate::sine::{SINE_OF, sine};

/// The name under which a module exports its memory.
pub(crate) const MEMORY: &str = "memory";

/// The types of functions, in the order in which a module lists them: of programs, of the host, of sine and cosine.
const PROGRAM: u32 = 0;
const HOST_FUNCTION: u32 = 1;
const ANGLE_FUNCTION: u32 = 2;

/// Steps of all programs of a module: more would take longer to translate than they could save.
const MOST_STEPS: usize = 8_000;

/// Numbers of a frame: as many as the interpreter has a narrow frame for.
pub(crate) const MOST_LANES: u32 = 256;

/// Places of a frame.
pub(crate) const MOST_PLACES_OF_ONE: u32 = 64;

/// What a module is made of.
#[derive(Debug)]
pub(crate) struct Plan {
    /// The programs, in the order of their functions.
    pub(crate) programs: Vec<u16>,
    pub(crate) shared: Shared,
}

impl Plan {
    /// The program `root` and those that it calls, as far as machine code can.
    pub(crate) fn new(image: &Image, root: u16) -> Option<Self> {
        let (mut programs, mut steps) = (Vec::new(), 0);
        let mut open = vec![root];
        while let Some(number) = open.pop() {
            let Some(program) = image.programs.get(usize::from(number)).filter(|program| suits(program)) else {
                continue;
            };
            if programs.contains(&number) || steps + program.code.len() > MOST_STEPS {
                continue;
            }
            programs.push(number);
            steps += program.code.len();
            let calls = program.code.iter().filter_map(|step| plain_call(step.op, program));
            open.extend(calls.map(|(_, callee)| callee));
        }
        let mut shared = Shared::default();
        let codes = programs.iter().filter_map(|number| image.programs.get(usize::from(*number)));
        let mut containers = codes.flat_map(|program| &program.code).filter_map(|step| container(step.op));
        let fits = containers.all(|whole| shared.add(whole));
        (fits && programs.contains(&root)).then_some(Self { programs, shared })
    }

    /// The steps of all programs.
    pub(crate) fn steps<'i>(&self, image: &'i Image) -> impl Iterator<Item = &'i Step> {
        self.programs
            .iter()
            .filter_map(|number| image.programs.get(usize::from(*number)))
            .flat_map(|program| &program.code)
    }

    /// The name under which a module exports a program.
    pub(crate) fn name(number: u16) -> String {
        number.to_string()
    }

    /// The module in the binary format of WebAssembly.
    pub(crate) fn encode(&self, image: &Image) -> Option<Vec<u8>> {
        let surroundings = Surroundings { image, programs: &self.programs, shared: &self.shared };
        let mut types = TypeSection::new();
        types.ty().function(SIGNATURE.0, SIGNATURE.1);
        types.ty().function(COMPUTE.0, COMPUTE.1);
        types.ty().function(SINE_OF.0, SINE_OF.1);
        let mut imports = ImportSection::new();
        imports.import(HOST, HOST, EntityType::Function(HOST_FUNCTION));
        let pages = u64::from(END / PAGE);
        let memory =
            MemoryType { minimum: pages, maximum: Some(pages), memory64: false, shared: false, page_size_log2: None };
        let mut memories = MemorySection::new();
        memories.memory(memory);
        let (mut functions, mut exports, mut codes) =
            (FunctionSection::new(), ExportSection::new(), CodeSection::new());
        exports.export(MEMORY, ExportKind::Memory, 0);
        for (number, index) in self.programs.iter().zip(FIRST..) {
            functions.function(PROGRAM);
            exports.export(&Self::name(*number), ExportKind::Func, index);
            codes.function(&function(&surroundings, *number)?);
        }
        if self.steps(image).any(|step| is_of_angle(step.op)) {
            // The sine, and the cosine, which is a quarter of a turn ahead.
            for ahead in [0, 1] {
                functions.function(ANGLE_FUNCTION);
                codes.function(&sine(ahead));
            }
        }
        let mut module = Module::new();
        module
            .section(&types)
            .section(&imports)
            .section(&functions)
            .section(&memories)
            .section(&exports)
            .section(&codes);
        Some(module.finish())
    }
}

fn suits(program: &Program) -> bool {
    program.frame.lanes.num <= MOST_LANES && program.frame.places <= MOST_PLACES_OF_ONE && !program.code.is_empty()
}
