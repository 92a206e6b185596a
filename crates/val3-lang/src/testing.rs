//! Test bench for handlers: variables, and calls of instructions in VAL 3 notation.
//!
//! Compiles a single call in a simple way. Its arguments select the form, which determines whether a name is passed as
//! a value, a place, a part of an array or a slot.

mod no_controller;
mod notation;
mod outside;

use std::collections::BTreeMap;

use self::notation::{VariableNotation, WrittenArgument, WrittenCall, WrittenSubscript};
use self::outside::NoController;
pub(crate) use self::outside::TaskList;
use crate::call::{Argument, Call, Caller, Flow, Reach, StoredValue, Waiting};
use crate::fault::{Fault, Result};
use crate::instruction::{Instruction, InstructionParam, Overload};
use crate::instructions;
use crate::memory::{ContainerShape, Memory, Place, Slot, StoreId, Subscript, View};
use crate::ports::Time;
use crate::types::{Arm, BaseType, LengthUnit};
use crate::values::{Text, printed};
use crate::versions::Version;

/// Variables, tasks and a clock.
#[derive(Default)]
pub(crate) struct Bench {
    pub(crate) memory: Memory,
    pub(crate) tasks: TaskList,
    pub(crate) now: Time,
    pub(crate) version: Version,
    pub(crate) unit: LengthUnit,
    pub(crate) arm: Option<Arm>,
    pub(crate) controller: NoController,
    waiting: Option<Waiting>,
    variables: BTreeMap<String, (View, BaseType)>,
}

/// Checks the result of a call without variables.
#[track_caller]
pub(crate) fn check(call: &str, expected: &str) {
    assert_eq!(Bench::default().run(call), expected, "{call}");
}

impl Bench {
    /// Adds global variables, declared as in a listing: `num nGrid[4,6]`, `point pPick`.
    pub(crate) fn global(mut self, declarations: &str) -> Self {
        for variable in declarations.split("; ").map(VariableNotation::parse) {
            let store = self.memory.create(&variable.init()).unwrap();
            self.declare(&variable, store);
        }
        self
    }

    /// Adds local variables. Each of them has a container here, even with a single value.
    pub(crate) fn local(mut self, declarations: &str) -> Self {
        for variable in declarations.split("; ").map(VariableNotation::parse) {
            let store = self.memory.create_local(&variable.init()).unwrap();
            self.declare(&variable, store);
        }
        self
    }

    fn declare(&mut self, variable: &VariableNotation<'_>, store: StoreId) {
        self.variables.insert(variable.name.to_owned(), (View::whole(store), variable.base));
    }

    /// Sets the numbers of a variable, from the first element on.
    pub(crate) fn with(mut self, name: &str, numbers: &[f64]) -> Self {
        self.set(name, numbers);
        self
    }

    /// As [`with`](Self::with).
    pub(crate) fn set(&mut self, name: &str, numbers: &[f64]) {
        let place = Place::first(self.view(name).store);
        for (lane, number) in (0..).zip(numbers) {
            self.memory.set_num(place, lane, *number).unwrap();
        }
    }

    /// Numbers of a variable.
    pub(crate) fn numbers(&self, name: &str) -> &[f64] {
        &self.memory.store(self.view(name).store).unwrap().nums
    }

    /// Sets the strings of a variable, from the first element on.
    pub(crate) fn with_texts(mut self, name: &str, texts: &[&str]) -> Self {
        let store = self.memory.store_mut(self.view(name).store).unwrap();
        for (value, text) in store.texts.iter_mut().zip(texts) {
            *value = Text::from(*text);
        }
        self
    }

    /// Inserts keys into a collection, in this order.
    pub(crate) fn with_keys(mut self, name: &str, keys: &[&str]) -> Self {
        let store = self.view(name).store;
        for key in keys {
            self.memory.insert_key(store, Text::from(*key), None).unwrap();
        }
        self
    }

    /// Makes a parameter refer to an array from an index on (2.6.3).
    pub(crate) fn part(mut self, name: &str, of: &str, start: u32) -> Self {
        let (view, base) = self.variables[of];
        self.variables.insert(name.to_owned(), (View { start, ..view }, base));
        self
    }

    /// Sets the clock, in nanoseconds.
    pub(crate) fn at(mut self, now: Time) -> Self {
        self.now = now;
        self
    }

    /// Executes a call, or the assignment of a call, and formats its value: `12`, `"a"`, `{1,2,3,0,0,0}`. Otherwise
    /// returns `error 20`, `waits` or `sleeps until 1.5`.
    #[track_caller]
    pub(crate) fn run(&mut self, line: &str) -> String {
        let line = WrittenCall::parse(line);
        let (instruction, form) = self.form(&line);
        let arguments: Vec<_> =
            form.params.iter().zip(&line.arguments).map(|(param, spoken)| self.argument(param, spoken)).collect();
        let target = line.target.as_ref().map(|target| self.place(target));
        let result = target.or_else(|| form.result.map(|base| Place::first(self.value_of(base))));
        let reach = Reach { memory: &mut self.memory, ports: &mut self.controller, tasks: &mut self.tasks };
        let caller = Caller { version: self.version, unit: self.unit, arm: self.arm };
        let mut call = Call::new(reach, caller, self.now, self.waiting, &arguments, result);
        let run = form.run.unwrap_or_else(|| panic!("{} has no handler", form.signature(instruction.name)));
        let flow = run(&mut call);
        self.waiting = match flow {
            Ok(Flow::Wait(wait)) => Some(Waiting::then(self.waiting, wait, self.now)),
            _ => None,
        };
        match flow {
            Ok(Flow::Done(())) => match (form.result, result) {
                (Some(base), Some(place)) => self.printed(place, base).unwrap(),
                _ => String::new(),
            },
            Ok(Flow::Wait(wait)) if wait.sleeps => format!("sleeps until {}", wait.wake.unwrap() as f64 / 1e9),
            Ok(Flow::Wait(_)) => "waits".to_owned(),
            Err(Fault(number)) => {
                assert!(instruction.errors.contains(&number), "{} does not list {number}", instruction.name);
                format!("error {number}")
            }
        }
    }

    /// Formats the elements of a variable, with their keys if it is a collection.
    pub(crate) fn show(&self, name: &str) -> String {
        let (view, base) = self.variables[name];
        let store = self.memory.store(view.store).unwrap();
        let value = |number| self.printed(store.place(view.store, number), base).unwrap();
        let values: Vec<_> = match &store.shape {
            ContainerShape::Array { .. } => (view.start..store.shape.len()).map(value).collect(),
            ContainerShape::Collection(keys) => {
                keys.iter().map(|(key, number)| format!("{key}: {}", value(*number))).collect()
            }
        };
        values.join(", ")
    }

    fn form(&self, line: &WrittenCall<'_>) -> (&'static Instruction, &'static Overload) {
        let instruction = instructions::find(line.name).unwrap();
        let form = instruction.overloads.iter().find(|form| {
            form.params.len() == line.arguments.len()
                && form.params.iter().zip(&line.arguments).all(|(param, spoken)| self.fits(param, spoken))
        });
        (instruction, form.unwrap_or_else(|| panic!("no form of {}", line.name)))
    }

    fn fits(&self, param: &InstructionParam, spoken: &WrittenArgument<'_>) -> bool {
        param.ty.is_none_or(|ty| match spoken {
            WrittenArgument::Num(_) => ty == BaseType::Num,
            WrittenArgument::Text(_) => ty == BaseType::String,
            WrittenArgument::Bool(_) => ty == BaseType::Bool,
            WrittenArgument::Structure(_) => matches!(ty, BaseType::Trsf | BaseType::Joint),
            WrittenArgument::Name(name, _) => self.variable(name).is_some_and(|(_, base)| base == ty),
        })
    }

    fn argument(&mut self, param: &InstructionParam, spoken: &WrittenArgument<'_>) -> Argument {
        use crate::instruction::ArgumentForm as Wanted;
        match (param.shape, spoken) {
            (Wanted::Value, WrittenArgument::Num(number)) => self.constant(BaseType::Num, &[*number]),
            (Wanted::Value, WrittenArgument::Bool(value)) => {
                self.constant(BaseType::Bool, &[f64::from(u8::from(*value))])
            }
            (Wanted::Value, WrittenArgument::Structure(numbers)) => self.constant(param.ty.unwrap(), numbers),
            (Wanted::Value, WrittenArgument::Text(text)) => {
                Argument::Value(self.text(Text::from(*text)), BaseType::String)
            }
            (Wanted::Slot | Wanted::Item, WrittenArgument::Name(name, at)) => {
                let at = self.subscript(at);
                Argument::Slot(Slot { view: self.variable(name).map(|(view, _)| view), at })
            }
            (Wanted::Reference, WrittenArgument::Name(name, at)) if param.ty.is_none() => {
                Argument::View(self.part_of(self.view(name), at))
            }
            (Wanted::Value | Wanted::Reference, WrittenArgument::Name(name, _)) => {
                Argument::Value(self.place(spoken), self.variable(name).unwrap().1)
            }
            (_, WrittenArgument::Name(name, at)) => Argument::View(self.part_of(self.view(name), at)),
            _ => panic!("{param} is no constant"),
        }
    }

    fn constant(&mut self, base: BaseType, numbers: &[f64]) -> Argument {
        let store = self.value_of(base);
        self.memory.store_mut(store).unwrap().nums.iter_mut().zip(numbers).for_each(|(lane, number)| *lane = *number);
        Argument::Value(Place::first(store), base)
    }

    /// Creates a container for an unnamed value.
    fn value_of(&mut self, base: BaseType) -> StoreId {
        self.memory.create_local(&VariableNotation { name: "", base, shape: ContainerShape::ELEMENT }.init()).unwrap()
    }

    fn variable(&self, name: &str) -> Option<(View, BaseType)> {
        match name {
            "world" => Some((View::whole(Memory::WORLD), BaseType::Frame)),
            "flange" => Some((View::whole(Memory::FLANGE), BaseType::Tool)),
            _ => self.variables.get(name).copied(),
        }
    }

    pub(crate) fn view(&self, name: &str) -> View {
        self.variable(name).unwrap_or_else(|| panic!("no variable {name}")).0
    }

    /// Creates an unnamed string.
    fn text(&mut self, text: Text) -> Place {
        let place = Place::first(self.value_of(BaseType::String));
        self.memory.set_text(place, text).unwrap();
        place
    }

    fn subscript(&mut self, at: &WrittenSubscript) -> Subscript<f64, Place> {
        match *at {
            Subscript::Whole => Subscript::Whole,
            Subscript::One(index) => Subscript::One(index),
            Subscript::Two(indexes) => Subscript::Two(indexes),
            Subscript::Three(indexes) => Subscript::Three(indexes),
            Subscript::Key(key) => Subscript::Key(self.text(key)),
        }
    }

    fn part_of(&self, view: View, at: &WrittenSubscript) -> View {
        match at {
            Subscript::Whole => view,
            Subscript::One(index) => {
                View { start: self.memory.store(view.store).unwrap().number1(view, *index).unwrap(), ..view }
            }
            _ => panic!("no part of an array"),
        }
    }

    fn place(&mut self, spoken: &WrittenArgument<'_>) -> Place {
        let WrittenArgument::Name(name, at) = spoken else { panic!("no variable") };
        let slot = Slot { view: Some(self.view(name)), at: self.subscript(at) };
        self.memory.locate(&slot).unwrap()
    }

    fn printed(&self, place: Place, base: BaseType) -> Result<String> {
        let structure =
            |numbers: &[f64]| printed::structure(&numbers.iter().map(|n| printed::num(*n)).collect::<Vec<_>>());
        Ok(match base {
            BaseType::Bool => printed::bool(bool::read(&self.memory, place)?).to_owned(),
            BaseType::Num => printed::num(f64::read(&self.memory, place)?).to_string(),
            BaseType::String => printed::string(&Text::read(&self.memory, place)?),
            _ => structure(&self.memory.nums::<6>(place, 0)?),
        })
    }
}
