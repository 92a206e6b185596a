//! Conversion of arguments to the parameters of handlers.

use std::marker::PhantomData;

use val3_geometry::Trsf;

use super::{Argument, Call};
use crate::enumerations;
use crate::fault::{Fault, Result};
use crate::memory::{LinkPlace, Memory, Place, Slot, View};
use crate::types::BaseType;
use crate::values::{ConfigValue, JointValue, MdescValue, Text};

/// A parameter of a handler.
pub trait FromArgument: Sized {
    /// Reads the next argument.
    ///
    /// # Errors
    /// 20 if the referenced data do not exist.
    fn take(call: &mut Call<'_>) -> Result<Self>;
}

/// A variable by reference, with values of type `T`.
#[derive(Debug)]
pub struct Var<T> {
    /// Address.
    pub place: Place,
    value: PhantomData<T>,
}

/// An array by reference.
#[derive(Debug)]
pub struct Arr<T> {
    /// Elements of the array.
    pub view: View,
    value: PhantomData<T>,
}

/// A value of any type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Any {
    /// Address.
    pub place: Place,
    /// Type; `None` for a user type.
    pub base: Option<BaseType>,
}

/// An input, output or line of the controller, by number; the number is `None` if the variable has no link (error 123).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct IoRef {
    /// Variable.
    pub place: Place,
    /// Target of the link.
    pub port: Option<u32>,
}

/// A `screen` variable (4.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ScreenRef(pub Place);

/// A frame. If the argument is a variable, it is passed by reference, so that it can be linked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FrameRef(pub Place);

/// A tool. If the argument is a variable, it is passed by reference, so that it can be linked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ToolRef(pub Place);

/// A point. If the argument is a variable, it is passed by reference, so that it can be linked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PointRef(pub Place);

/// A value in a variable.
pub trait StoredValue: Sized {
    /// Reads the value.
    ///
    /// # Errors
    /// 20 if it does not exist.
    fn read(memory: &Memory, at: Place) -> Result<Self>;

    /// Writes the value.
    ///
    /// # Errors
    /// 20 if it does not exist.
    fn write(self, memory: &mut Memory, at: Place) -> Result<()>;
}

impl StoredValue for f64 {
    #[inline]
    fn read(memory: &Memory, at: Place) -> Result<Self> {
        memory.num(at, 0)
    }

    #[inline]
    fn write(self, memory: &mut Memory, at: Place) -> Result<()> {
        memory.set_num(at, 0, self)
    }
}

impl StoredValue for bool {
    #[inline]
    fn read(memory: &Memory, at: Place) -> Result<Self> {
        Ok(memory.num(at, 0)? != 0.0)
    }

    #[inline]
    fn write(self, memory: &mut Memory, at: Place) -> Result<()> {
        memory.set_num(at, 0, f64::from(u8::from(self)))
    }
}

impl StoredValue for Text {
    #[inline]
    fn read(memory: &Memory, at: Place) -> Result<Self> {
        memory.text(at).copied()
    }

    #[inline]
    fn write(self, memory: &mut Memory, at: Place) -> Result<()> {
        memory.set_text(at, self)
    }
}

impl StoredValue for Trsf {
    #[inline]
    fn read(memory: &Memory, at: Place) -> Result<Self> {
        let [x, y, z, rx, ry, rz] = memory.nums(at, 0)?;
        Ok(Self { x, y, z, rx, ry, rz })
    }

    #[inline]
    fn write(self, memory: &mut Memory, at: Place) -> Result<()> {
        memory.set_nums(at, 0, [self.x, self.y, self.z, self.rx, self.ry, self.rz])
    }
}

impl StoredValue for JointValue {
    #[inline]
    fn read(memory: &Memory, at: Place) -> Result<Self> {
        Ok(Self(memory.nums(at, 0)?))
    }

    #[inline]
    fn write(self, memory: &mut Memory, at: Place) -> Result<()> {
        memory.set_nums(at, 0, self.0)
    }
}

impl StoredValue for ConfigValue {
    #[inline]
    fn read(memory: &Memory, at: Place) -> Result<Self> {
        Ok(Self(memory.nums(at, 0)?))
    }

    #[inline]
    fn write(self, memory: &mut Memory, at: Place) -> Result<()> {
        memory.set_nums(at, 0, self.0)
    }
}

impl StoredValue for MdescValue {
    #[inline]
    fn read(memory: &Memory, at: Place) -> Result<Self> {
        let [accel, vel, decel, tvel, rvel, blend, leave, reach] = memory.nums(at, 0)?;
        Ok(Self { accel, vel, decel, tvel, rvel, blend: enumerations::blend_of(blend), leave, reach })
    }

    #[inline]
    fn write(self, memory: &mut Memory, at: Place) -> Result<()> {
        let Self { accel, vel, decel, tvel, rvel, blend, leave, reach } = self;
        let blend = enumerations::blend_number(blend);
        memory.set_nums(at, 0, [accel, vel, decel, tvel, rvel, blend, leave, reach])
    }
}

impl<T: StoredValue> Var<T> {
    /// Returns the value.
    ///
    /// # Errors
    /// 20 if it does not exist.
    pub fn get(&self, call: &Call<'_>) -> Result<T> {
        T::read(call.memory, self.place)
    }

    /// Sets the value.
    ///
    /// # Errors
    /// 20 if it does not exist.
    pub fn set(&self, call: &mut Call<'_>, value: T) -> Result<()> {
        value.write(call.memory, self.place)
    }
}

impl<T: StoredValue> Arr<T> {
    /// Number of elements.
    ///
    /// # Errors
    /// 20 if the array does not exist.
    pub fn len(&self, call: &Call<'_>) -> Result<usize> {
        Ok(call.memory.len(self.view)? as usize)
    }

    /// Whether the array has no elements.
    ///
    /// # Errors
    /// 20 if the array does not exist.
    pub fn is_empty(&self, call: &Call<'_>) -> Result<bool> {
        Ok(self.len(call)? == 0)
    }

    /// Returns an element.
    ///
    /// # Errors
    /// 20 beyond the size.
    pub fn get(&self, call: &Call<'_>, index: usize) -> Result<T> {
        T::read(call.memory, self.place(call, index)?)
    }

    /// Sets an element.
    ///
    /// # Errors
    /// 20 beyond the size.
    pub fn set(&self, call: &mut Call<'_>, index: usize, value: T) -> Result<()> {
        let place = self.place(call, index)?;
        value.write(call.memory, place)
    }

    /// Returns all elements.
    ///
    /// # Errors
    /// 20 if the array does not exist.
    pub fn all(&self, call: &Call<'_>) -> Result<Vec<T>> {
        (0..self.len(call)?).map(|index| self.get(call, index)).collect()
    }

    /// Sets elements, from the first one on.
    ///
    /// # Errors
    /// 20 beyond the size.
    pub fn set_all(&self, call: &mut Call<'_>, values: impl IntoIterator<Item = T>) -> Result<()> {
        values.into_iter().enumerate().try_for_each(|(index, value)| self.set(call, index, value))
    }

    /// Element address.
    ///
    /// # Errors
    /// 20 beyond the size.
    pub fn place(&self, call: &Call<'_>, index: usize) -> Result<Place> {
        call.memory.element(self.view, u32::try_from(index).map_err(|_| Fault::INDEX_TOO_LARGE)?)
    }
}

#[inline]
fn place(call: &mut Call<'_>) -> Result<Place> {
    match call.argument()? {
        Argument::Value(place, _) | Argument::UserValue(place) => Ok(place),
        Argument::View(view) => call.memory.element(view, 0),
        Argument::Slot(_) | Argument::Library(_) => Err(Fault::INTERPRETER),
    }
}

macro_rules! by_value {
    ($($ty:ty),*) => {
        $(impl FromArgument for $ty {
            #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
                let place = place(call)?;
                Self::read(call.memory, place)
            }
        })*
    };
}
by_value!(f64, bool, Text, Trsf, JointValue, ConfigValue, MdescValue);

macro_rules! by_place {
    ($($ty:ident),*) => {
        $(impl FromArgument for $ty {
            #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
                place(call).map(Self)
            }
        })*
    };
}
by_place!(ScreenRef, FrameRef, ToolRef, PointRef);

impl FromArgument for IoRef {
    #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
        let place = place(call)?;
        Self::read(call.memory, place)
    }
}

impl StoredValue for IoRef {
    #[inline]
    fn read(memory: &Memory, at: Place) -> Result<Self> {
        let port = match memory.link(at, 0)? {
            LinkPlace::Port(port) => Some(port),
            LinkPlace::None | LinkPlace::Data(_) => None,
        };
        Ok(Self { place: at, port })
    }

    #[inline]
    fn write(self, memory: &mut Memory, at: Place) -> Result<()> {
        memory.set_link(at, 0, self.port.map_or(LinkPlace::None, LinkPlace::Port))
    }
}

impl<T> FromArgument for Var<T> {
    #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
        Ok(Self { place: place(call)?, value: PhantomData })
    }
}

impl<T> FromArgument for Arr<T> {
    #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
        Ok(Self { view: View::take(call)?, value: PhantomData })
    }
}

impl FromArgument for View {
    #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
        match call.argument()? {
            Argument::View(view) => Ok(view),
            _ => Err(Fault::INTERPRETER),
        }
    }
}

impl FromArgument for Slot {
    #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
        match call.argument()? {
            Argument::Slot(slot) => Ok(slot),
            _ => Err(Fault::INTERPRETER),
        }
    }
}

impl FromArgument for Any {
    #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
        match call.argument()? {
            Argument::Value(place, base) => Ok(Self { place, base: Some(base) }),
            Argument::UserValue(place) => Ok(Self { place, base: None }),
            _ => Err(Fault::INTERPRETER),
        }
    }
}

/// Library identifier on which a form `on library` is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LibraryRef(pub u16);

impl FromArgument for LibraryRef {
    #[inline]
    fn take(call: &mut Call<'_>) -> Result<Self> {
        match call.argument()? {
            Argument::Library(number) => Ok(Self(number)),
            _ => Err(Fault::INTERPRETER),
        }
    }
}
