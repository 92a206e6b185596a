//! Declarations of structures, choices, enumerations and operations.

/// Declares a structure: each field with type and element name, and lists also with the name of the inner elements.
///
/// Child elements may be in any order. Unknown children are ignored, because newer clients may send more.
macro_rules! structure {
    ($(#[$meta:meta])* $name:ident {}) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name;

        impl crate::value::SoapValue for $name {
            fn read(_: &crate::document::SoapElement) -> Result<Self, crate::error::SoapError> {
                Ok(Self)
            }

            fn write(&self, _: &mut crate::document::SoapElement) {}
        }
    };
    ($(#[$meta:meta])* $name:ident { $($(#[$doc:meta])* $field:ident: $ty:ty = $xml:literal $(of $item:literal)?,)* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name { $($(#[$doc])* pub $field: $ty,)* }

        impl crate::value::SoapValue for $name {
            fn read(element: &crate::document::SoapElement) -> Result<Self, crate::error::SoapError> {
                Ok(Self { $($field: structure!(@read element, $xml $(of $item)?)?,)* })
            }

            fn write(&self, element: &mut crate::document::SoapElement) {
                $(structure!(@write self.$field, element, $xml $(of $item)?);)*
            }
        }
    };
    (@read $element:ident, $xml:literal) => { crate::value::SoapField::read_field($element, $xml) };
    (@read $element:ident, $xml:literal of $item:literal) => { crate::value::read_list($element, $xml, $item) };
    (@write $value:expr, $element:ident, $xml:literal) => {
        crate::value::SoapField::write_field(&$value, $xml, $element)
    };
    (@write $value:expr, $element:ident, $xml:literal of $item:literal) => {
        crate::value::write_list(&$value, $xml, $item, $element)
    };
}

/// Declares a choice: an element that contains exactly one of several elements.
macro_rules! choice {
    ($(#[$meta:meta])* $name:ident { $($(#[$doc:meta])* $variant:ident($ty:ty) = $xml:literal,)* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq)]
        pub enum $name { $($(#[$doc])* $variant($ty),)* }

        impl crate::value::SoapValue for $name {
            fn read(element: &crate::document::SoapElement) -> Result<Self, crate::error::SoapError> {
                let mut choices = Vec::new();
                $(if let Some(child) = crate::value::only_child(element, $xml)? {
                    choices.push(Self::$variant(crate::value::SoapValue::read(child)?));
                })*
                match (choices.pop(), choices.pop()) {
                    (Some(choice), None) => Ok(choice),
                    (first, _) => {
                        let found = if first.is_some() { "several of them" } else { "none of them" };
                        let expected = concat!("one of", $(" `", $xml, "`"),*);
                        Err(crate::error::SoapError::wrong_value(&element.name, found, expected))
                    }
                }
            }

            fn write(&self, element: &mut crate::document::SoapElement) {
                match self {
                    $(Self::$variant(value) => crate::value::SoapField::write_field(value, $xml, element),)*
                }
            }
        }
    };
}

/// Declares an enumeration: each value with its text in messages.
macro_rules! enumeration {
    ($(#[$meta:meta])* $name:ident { $($(#[$doc:meta])* $variant:ident = $text:literal,)* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name { $($(#[$doc])* $variant,)* }

        impl $name {
            /// All values, sorted by number.
            pub const ALL: &[Self] = &[$(Self::$variant,)*];

            /// Text in messages.
            #[must_use]
            pub const fn text(self) -> &'static str {
                match self { $(Self::$variant => $text,)* }
            }
        }

        impl crate::value::SoapValue for $name {
            fn read(element: &crate::document::SoapElement) -> Result<Self, crate::error::SoapError> {
                let expected = concat!("a value of the enumeration ", stringify!($name));
                let text = element.leaf_text(expected)?.trim();
                let value = Self::ALL.iter().copied().find(|value| value.text() == text);
                value.ok_or_else(|| crate::error::SoapError::wrong_value(&element.name, text, expected))
            }

            fn write(&self, element: &mut crate::document::SoapElement) {
                element.text.push_str(self.text());
            }
        }
    };
}

/// Declares an operation: its request, server, name, answer and the name of the answer's element.
macro_rules! operation {
    ($request:ident: $server:ident $name:literal => $answer:ty, $answer_name:literal) => {
        operation!(@ $request, $server, $name, $answer, $answer_name, true);
    };
    ($request:ident: $server:ident $name:literal => $answer:ty, $answer_name:literal, without session) => {
        operation!(@ $request, $server, $name, $answer, $answer_name, false);
    };
    (@ $request:ident, $server:ident, $name:literal, $answer:ty, $answer_name:literal, $session:literal) => {
        impl crate::value::Operation for $request {
            const SERVER: crate::server::SoapServer = crate::server::SoapServer::$server;
            const NAME: &'static str = $name;
            const ANSWER: &'static str = $answer_name;
            const NEEDS_SESSION: bool = $session;
            type Answer = $answer;
        }
    };
}

pub(crate) use {choice, enumeration, operation, structure};
