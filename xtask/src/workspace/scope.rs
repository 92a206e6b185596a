//! Variables that a program can name, by the type of value.

use super::model::{Container, Data, Parameter, Type, Variable};
use super::random::Random;
use super::shared::SIGNALS;

/// A value inside a variable: the variable with its index, or a field.
#[derive(Debug, Clone)]
struct ValueRef {
    name: String,
    container: Container,
    /// `.trsf.z`, or empty.
    field: &'static str,
    ty: Type,
    /// Whether the program only reads it.
    fixed: bool,
}

/// All values that a program can name.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope {
    places: Vec<ValueRef>,
    /// Counters of `for`, usable as indexes.
    counters: Vec<String>,
}

impl Scope {
    /// Creates the scope with the data of the application and its libraries.
    pub(super) fn of_application(data: &[Data]) -> Self {
        let mut scope = Self::default();
        for data in data {
            scope.add(&data.variable);
        }
        let signals = Container::Array(SIGNALS);
        scope.add(&Variable { name: "io:dIn".to_owned(), ty: Type::Dio, container: signals });
        scope.add(&Variable::one("logbook:nEntries", Type::Num));
        scope.add(&Variable::one("logbook:bVerbose", Type::Bool));
        scope
    }

    /// Adds a variable with its fields.
    pub(super) fn add(&mut self, variable: &Variable) {
        for (field, ty) in fields(variable.ty) {
            let fixed = !field.is_empty() && variable.ty == Type::Tool;
            let (name, container) = (variable.name.clone(), variable.container);
            self.places.push(ValueRef { name, container, field, ty: *ty, fixed });
        }
    }

    /// Adds a parameter. A parameter by value is only read.
    pub(super) fn add_parameter(&mut self, parameter: &Parameter) {
        let before = self.places.len();
        self.add(&parameter.variable);
        if !parameter.by_reference {
            self.places.iter_mut().skip(before).for_each(|place| place.fixed = true);
        }
    }

    /// Adds a counter that may be used as an index from now on.
    pub(super) fn push_counter(&mut self, counter: &str) {
        self.counters.push(counter.to_owned());
    }

    /// Removes the innermost counter.
    pub(super) fn pop_counter(&mut self) {
        self.counters.pop();
    }

    /// Whether the counter is in use.
    pub(super) fn has_counter(&self, counter: &str) -> bool {
        self.counters.iter().any(|other| other == counter)
    }

    /// Returns a value to read.
    pub(super) fn readable(&self, ty: Type, random: &mut Random) -> Option<String> {
        let places: Vec<_> = self.places.iter().filter(|place| place.ty == ty).collect();
        let place = random.pick(&places)?;
        Some(self.spell(place, random))
    }

    /// Returns a variable to write to.
    pub(super) fn writable(&self, ty: Type, random: &mut Random) -> Option<String> {
        let places: Vec<_> = self.places.iter().filter(|place| place.ty == ty && !place.fixed).collect();
        let place = random.pick(&places)?;
        Some(self.spell(place, random))
    }

    /// Returns a variable to pass by reference: not a field.
    pub(super) fn reference(&self, ty: Type, random: &mut Random) -> Option<String> {
        let fits = |place: &&ValueRef| place.ty == ty && !place.fixed && place.field.is_empty();
        let places: Vec<_> = self.places.iter().filter(fits).collect();
        let place = random.pick(&places)?;
        Some(self.spell(place, random))
    }

    /// Returns the name of a one-dimensional array.
    pub(super) fn array(&self, ty: Type, random: &mut Random) -> Option<String> {
        let whole = self.places.iter().filter(|place| place.ty == ty && place.field.is_empty());
        let places: Vec<_> = whole.filter(|place| matches!(place.container, Container::Array(_))).collect();
        random.pick(&places).map(|place| place.name.clone())
    }

    fn spell(&self, place: &ValueRef, random: &mut Random) -> String {
        let ValueRef { name, container, field, .. } = place;
        let index = match *container {
            Container::One => String::new(),
            Container::Array(size) => format!("[{}]", self.index(size, random)),
            Container::Grid(rows, columns) => {
                format!("[{},{}]", self.index(rows, random), self.index(columns, random))
            }
            Container::Collection(keys) => format!("[\"{}\"]", random.word(keys)),
        };
        format!("{name}{index}{field}")
    }

    /// Returns a counter, or an index within the array.
    fn index(&self, size: usize, random: &mut Random) -> String {
        match random.pick(&self.counters) {
            Some(counter) if random.chance(60) => counter.clone(),
            _ => random.below(size).to_string(),
        }
    }
}

/// Returns the paths into a variable of a type: the variable itself, then its fields.
fn fields(ty: Type) -> &'static [(&'static str, Type)] {
    match ty {
        Type::Num => &[("", Type::Num)],
        Type::Bool => &[("", Type::Bool)],
        Type::Text => &[("", Type::Text)],
        Type::Point => &[("", Type::Point), (".trsf", Type::Trsf), (".trsf.x", Type::Num), (".trsf.z", Type::Num)],
        Type::Joint => &[("", Type::Joint), (".j1", Type::Num), (".j6", Type::Num)],
        Type::Trsf => &[("", Type::Trsf), (".x", Type::Num), (".rz", Type::Num)],
        Type::Frame => &[("", Type::Frame)],
        Type::Tool => &[("", Type::Tool), (".trsf.z", Type::Num)],
        Type::Mdesc => &[("", Type::Mdesc), (".vel", Type::Num)],
        Type::Dio => &[("", Type::Dio)],
        Type::Slot => &[
            ("", Type::Slot),
            (".pPlace", Type::Point),
            (".nCount", Type::Num),
            (".nSize[1]", Type::Num),
            (".sLabel", Type::Text),
            (".bFull", Type::Bool),
        ],
    }
}
