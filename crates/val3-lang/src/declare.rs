//! Macros that declare the catalogue.

/// Declares the instruction of a file.
///
/// The doc comment is the instruction's page. The head line contains name, family and manual section, then the clauses
/// `blocking`, `role(effect on the recorded moves)`, `errors [numbers]`, `since major`, `until major` and `with_add_on
/// "name"`.
///
/// Every further line is a form: `function` (only returns a value) or `modifier` (can be a statement), parameters as in
/// a syntax line, `-> type` for a value, `on library` for a form of a library identifier, `since major` for a form in
/// later versions, `seen in_programs` for a form that the manual does not contain, `= function` for the handler, whose
/// parameters have the types in the line ([`FromArgument`](crate::call::FromArgument)). In place of a type, a parameter
/// has `any`, `Whole`, `Slot`, `Item` ([`ArgumentForm`](crate::instruction::ArgumentForm)) or `program` (a program call).
macro_rules! instruction {
    (
        $(#[doc = $line:literal])*
        $name:literal: $family:ident $($section:literal)?
            $(, $clause:ident $($value:literal)? $([$($item:literal),*])? $(($($role:ident)+))?)*;
        $(
            $class:ident ($(
                $ty:ident $($by_value:ident)? $(& $by_reference:ident)? $([$($dims:tt)*])?
            ),*) $(-> $result:ident)? $(on $library:ident)? $(since $since:literal)? $(seen $seen:ident)? $(= $run:path)?;
        )+
    ) => {
        $(#[doc = $line])*
        #[allow(non_snake_case, reason = "arguments are named as in the syntax line")]
        pub(crate) static INSTRUCTION: $crate::instruction::Instruction =
            $crate::instruction::Instruction::new($name, $crate::instruction::Family::$family)
                .described(concat!($($section)?), concat!($($line, "\n"),*))
                .forms(&[$(
                    $crate::instruction::Overload {
                        on_library: $crate::declare::stated!($($library)?),
                        params: &[$(
                            $crate::declare::param!($ty $($by_value)? $(& $by_reference)? $([$($dims)*])?)
                        ),*],
                        result: $crate::declare::result!($($result)?),
                        class: $crate::declare::class!($class),
                        since: $crate::declare::optional!($($since)?),
                        is_printed: !$crate::declare::stated!($($seen)?),
                        run: $crate::declare::run!(
                            [$($run)?] [$($library)?]
                            $($ty $($by_value)? $(& $by_reference)? $([$($dims)*])?),*
                        ),
                    }
                ),+])
                $(.$clause($($value)? $(&[$($item),*])? $($crate::declare::role!($($role)+))?))*;
    };
}
pub(crate) use instruction;

/// [`MotionRole`](crate::motion::MotionRole) of an instruction: `Arrive`, or `Move` with a path.
macro_rules! role {
    (Move $path:ident) => {
        $crate::motion::MotionRole::Move($crate::motion::RequestedPath::$path)
    };
    ($role:ident) => {
        $crate::motion::MotionRole::$role
    };
}
pub(crate) use role;

macro_rules! param {
    (program $name:ident) => {
        $crate::declare::param!(@ $name, None, ProgramCall)
    };
    (Whole $name:ident) => {
        $crate::declare::param!(@ $name, None, Whole)
    };
    (Slot $name:ident) => {
        $crate::declare::param!(@ $name, None, Slot)
    };
    (Item $name:ident) => {
        $crate::declare::param!(@ $name, None, Item)
    };
    ($ty:ident $name:ident) => {
        $crate::declare::param!(@ $name, $crate::declare::base_type!($ty), Value)
    };
    ($ty:ident & $name:ident) => {
        $crate::declare::param!(@ $name, $crate::declare::base_type!($ty), Reference)
    };
    ($ty:ident & $name:ident [""]) => {
        $crate::declare::param!(@ $name, $crate::declare::base_type!($ty), Collection)
    };
    ($ty:ident & $name:ident []) => {
        $crate::declare::param!(@ $name, $crate::declare::base_type!($ty), Array { dims: 1 })
    };
    (@ $name:ident, $ty:expr, $($shape:tt)+) => {
        $crate::instruction::InstructionParam {
            name: stringify!($name),
            ty: $ty,
            shape: $crate::instruction::ArgumentForm::$($shape)+,
        }
    };
}
pub(crate) use param;

macro_rules! base_type {
    (any) => {
        None
    };
    (bool) => {
        Some($crate::types::BaseType::Bool)
    };
    (num) => {
        Some($crate::types::BaseType::Num)
    };
    (string) => {
        Some($crate::types::BaseType::String)
    };
    (dio) => {
        Some($crate::types::BaseType::Dio)
    };
    (aio) => {
        Some($crate::types::BaseType::Aio)
    };
    (sio) => {
        Some($crate::types::BaseType::Sio)
    };
    (screen) => {
        Some($crate::types::BaseType::Screen)
    };
    (trsf) => {
        Some($crate::types::BaseType::Trsf)
    };
    (frame) => {
        Some($crate::types::BaseType::Frame)
    };
    (tool) => {
        Some($crate::types::BaseType::Tool)
    };
    (point) => {
        Some($crate::types::BaseType::Point)
    };
    (joint) => {
        Some($crate::types::BaseType::Joint)
    };
    (config) => {
        Some($crate::types::BaseType::Config)
    };
    (mdesc) => {
        Some($crate::types::BaseType::Mdesc)
    };
}
pub(crate) use base_type;

macro_rules! result {
    () => {
        None
    };
    ($ty:ident) => {
        $crate::declare::base_type!($ty)
    };
}
pub(crate) use result;

macro_rules! class {
    (function) => {
        $crate::instruction::CallClass::Function
    };
    (modifier) => {
        $crate::instruction::CallClass::Modifier
    };
}
pub(crate) use class;

macro_rules! stated {
    () => {
        false
    };
    (library) => {
        true
    };
    (in_programs) => {
        true
    };
}
pub(crate) use stated;

macro_rules! optional {
    () => {
        None
    };
    ($value:literal) => {
        Some($value)
    };
}
pub(crate) use optional;

/// Function that reads the arguments of a form, calls its handler and writes the result.
macro_rules! run {
    ([] [$($library:ident)?] $($param:tt)*) => {
        None
    };
    ([$run:path] [] $($ty:ident $($by_value:ident)? $(& $by_reference:ident)? $([$($dims:tt)*])?),*) => {
        Some(|call| {
            $($crate::declare::take!(call, $ty $($by_value)? $(& $by_reference)? $([$($dims)*])?);)*
            let outcome = $run(call, $($($by_value)? $($by_reference)?),*);
            $crate::call::HandlerResult::settle(outcome, call)
        })
    };
    ([$run:path] [$library:ident] $($ty:ident $($by_value:ident)? $(& $by_reference:ident)? $([$($dims:tt)*])?),*) => {
        Some(|call| {
            let $library: $crate::call::LibraryRef = $crate::call::FromArgument::take(call)?;
            $($crate::declare::take!(call, $ty $($by_value)? $(& $by_reference)? $([$($dims)*])?);)*
            let outcome = $run(call, $library, $($($by_value)? $($by_reference)?),*);
            $crate::call::HandlerResult::settle(outcome, call)
        })
    };
}
pub(crate) use run;

/// Reads an argument into a variable with the parameter's name.
macro_rules! take {
    ($call:ident, program $name:ident) => {
        compile_error!("a program is called by a statement of its own")
    };
    ($call:ident, Whole $name:ident) => {
        let $name: $crate::memory::View = $crate::call::FromArgument::take($call)?;
    };
    ($call:ident, Slot $name:ident) => {
        let $name: $crate::memory::Slot = $crate::call::FromArgument::take($call)?;
    };
    ($call:ident, Item $name:ident) => {
        let $name: $crate::memory::Slot = $crate::call::FromArgument::take($call)?;
    };
    ($call:ident, $ty:ident $name:ident) => {
        let $name: $crate::declare::value!($ty) = $crate::call::FromArgument::take($call)?;
    };
    ($call:ident, any & $name:ident) => {
        let $name: $crate::memory::View = $crate::call::FromArgument::take($call)?;
    };
    ($call:ident, $ty:ident & $name:ident) => {
        let $name: $crate::call::Var<$crate::declare::value!($ty)> = $crate::call::FromArgument::take($call)?;
    };
    ($call:ident, $ty:ident & $name:ident [""]) => {
        let $name: $crate::memory::View = $crate::call::FromArgument::take($call)?;
    };
    ($call:ident, $ty:ident & $name:ident []) => {
        let $name: $crate::call::Arr<$crate::declare::value!($ty)> = $crate::call::FromArgument::take($call)?;
    };
}
pub(crate) use take;

/// Type of a handler's parameter.
macro_rules! value {
    (any) => {
        $crate::call::Any
    };
    (bool) => {
        bool
    };
    (num) => {
        f64
    };
    (string) => {
        $crate::values::Text
    };
    (dio) => {
        $crate::call::IoRef
    };
    (aio) => {
        $crate::call::IoRef
    };
    (sio) => {
        $crate::call::IoRef
    };
    (screen) => {
        $crate::call::ScreenRef
    };
    (trsf) => {
        val3_geometry::Trsf
    };
    (frame) => {
        $crate::call::FrameRef
    };
    (tool) => {
        $crate::call::ToolRef
    };
    (point) => {
        $crate::call::PointRef
    };
    (joint) => {
        $crate::values::JointValue
    };
    (config) => {
        $crate::values::ConfigValue
    };
    (mdesc) => {
        $crate::values::MdescValue
    };
}
pub(crate) use value;

/// Declares the catalogue's files by family, and the list of instructions.
macro_rules! catalogue {
    ($($family:ident { $($name:ident),+ $(,)? })+) => {
        $(mod $family { $(pub(crate) mod $name;)+ })+

        /// Every instruction, by family in the manual's order.
        static CATALOGUE: &[&$crate::instruction::Instruction] =
            &[$($(&$family::$name::INSTRUCTION),+),+];
    };
}
pub(crate) use catalogue;
