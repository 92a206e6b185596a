//! Forms that consist of other forms.

use std::marker::PhantomData;
use std::str::FromStr;

use super::ListingForm;
use super::error::Result;
use super::reader::ListingReader;
use super::writer::Writer;

/// Structures: the fields in this order.
macro_rules! sequences {
    ($($type:ty { $($field:ident: $form:ty),+ };)+) => {$(
        impl ListingForm for $type {
            type Value = Self;

            fn write(value: &Self, to: &mut Writer<'_>) {
                $(to.part(|to| <$form>::write(&value.$field, to));)+
            }

            fn read(from: &mut ListingReader<'_>) -> Result<Self> {
                Ok(Self { $($field: <$form>::read(from)?),+ })
            }
        }
    )+};
}

/// Enumerations: a word for each variant, then its fields. The last variants may have a separate form.
macro_rules! choices {
    ($($type:ty, $expected:literal {
        $($word:literal $variant:ident $(($($field:ident: $form:ty),+))?,)+ $(_ => $other:ty,)?
    })+) => {$(
        impl ListingForm for $type {
            type Value = Self;

            fn write(value: &Self, to: &mut Writer<'_>) {
                match value {
                    $(Self::$variant $(($($field),+))? => {
                        to.put($word);
                        $($(to.part(|to| <$form>::write($field, to));)+)?
                    })+
                    $(other => <$other>::write(other, to),)?
                }
            }

            fn read(from: &mut ListingReader<'_>) -> Result<Self> {
                $(if from.accept($word) {
                    return Ok(Self::$variant $(($(<$form>::read(from)?),+))?);
                })+
                $(if !from.is_at_end() {
                    return <$other>::read(from);
                })?
                from.unexpected($expected)
            }
        }
    )+};
}

pub(super) use {choices, sequences};

/// A word of the text form.
pub(super) trait Word {
    const WORD: &str;
}

/// Words that mark optional parts.
macro_rules! words {
    ($($name:ident $word:literal;)+) => {$(
        #[doc = concat!("`", $word, "`")]
        pub(super) struct $name;

        impl Word for $name {
            const WORD: &str = $word;
        }
    )+};
}

words! {
    Autoload "autoload";
    InArm "arm";
    From "from";
    Of "of";
    Overrun "overrun";
    Public "public";
    Reference "&";
    To "->";
}

/// An optional word.
pub(super) struct Flag<W>(PhantomData<W>);

impl<W: Word> ListingForm for Flag<W> {
    type Value = bool;

    fn write(value: &bool, to: &mut Writer<'_>) {
        to.put(if *value { W::WORD } else { "" });
    }

    fn read(from: &mut ListingReader<'_>) -> Result<bool> {
        Ok(from.accept(W::WORD))
    }
}

/// An optional word that is followed by another form.
pub(super) struct Optional<W, F>(PhantomData<(W, F)>);

impl<W: Word, F: ListingForm> ListingForm for Optional<W, F> {
    type Value = Option<F::Value>;

    fn write(value: &Self::Value, to: &mut Writer<'_>) {
        if let Some(value) = value {
            to.put(W::WORD);
            to.part(|to| F::write(value, to));
        }
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self::Value> {
        if from.accept(W::WORD) { F::read(from).map(Some) } else { Ok(None) }
    }
}

/// A list in parentheses.
pub(super) struct Listed<F>(PhantomData<F>);

impl<F: ListingForm> ListingForm for Listed<F> {
    type Value = Vec<F::Value>;

    fn write(value: &Self::Value, to: &mut Writer<'_>) {
        to.put("(");
        to.list(value, ", ", F::write);
        to.put(")");
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self::Value> {
        from.expect("(")?;
        from.list(",", ")", F::read)
    }
}

/// Tuples: one form after the other.
macro_rules! tuples {
    ($(($($form:ident $value:ident),+);)+) => {$(
        impl<$($form: ListingForm),+> ListingForm for ($($form),+) {
            type Value = ($($form::Value),+);

            fn write(values: &Self::Value, to: &mut Writer<'_>) {
                let ($($value),+) = values;
                $(to.part(|to| $form::write($value, to));)+
            }

            fn read(from: &mut ListingReader<'_>) -> Result<Self::Value> {
                Ok(($($form::read(from)?),+))
            }
        }
    )+};
}

tuples! {
    (A a, B b);
    (A a, B b, C c);
}

/// A number without a letter.
pub(super) struct Number<N = u32>(PhantomData<N>);

impl<N: FromStr + ToString> ListingForm for Number<N> {
    type Value = N;

    fn write(value: &N, to: &mut Writer<'_>) {
        to.put(&value.to_string());
    }

    fn read(from: &mut ListingReader<'_>) -> Result<N> {
        from.number()
    }
}

/// A name, quoted if it is not an identifier.
pub(super) struct Name;

impl ListingForm for Name {
    type Value = String;

    fn write(value: &String, to: &mut Writer<'_>) {
        to.name(value);
    }

    fn read(from: &mut ListingReader<'_>) -> Result<String> {
        from.name()
    }
}

/// A string in quotation marks.
pub(super) struct Quoted;

impl ListingForm for Quoted {
    type Value = String;

    fn write(value: &String, to: &mut Writer<'_>) {
        to.quoted(value);
    }

    fn read(from: &mut ListingReader<'_>) -> Result<String> {
        from.quoted()
    }
}
