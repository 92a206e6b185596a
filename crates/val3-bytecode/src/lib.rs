//! Instruction set of the virtual controller: applications as images, with source maps.
//!
//! An image is the compiled form of an application or library. Its code is for a register machine: a program's stack
//! frame has lanes of numbers, texts, links and containers (see [`val3_lang::memory`]), and operations refer to lanes
//! of the current frame. Parameters come first, then locals, then constants and temporaries.

mod counters;
mod fragment;
mod image;
mod op;
mod operand;
mod passes;
mod program;
mod site;
mod text;

pub use counters::{Branch, BranchSide, Counters};
pub use fragment::{Fragment, FragmentValue};
pub use image::{DataDef, FatherLink, Image, Import, ImportKind, LibraryDef, LinkInit, LinkTarget};
pub use op::{LineMark, Op, Opcode, Register};
pub use operand::{ContainerKind, ContainerRef, Operand, Subscript, TextOperand, TextSource};
pub use passes::plan_passes;
pub use program::{FrameSize, FrameVariable, Program, ProgramParam, SourceLine, SourceRange, Storage};
pub use site::{ArgumentSite, CallSite, Callee, CopySite, Handler, InstructionSite, Pass, ProgramRef, TaskSite};
pub use text::{AssemblyError, assemble, disassemble, disassemble_program};
