//! What varisat takes from the package of this name, but without traces.
//!
//! The package keeps with each error how it came about, and can print that; in Wasm
//! there is nothing to keep, yet what prints it is in every page: 30 kB of code that
//! reads the names of functions. The workspace puts this in the place of the package
//! (`[patch]` in its manifest).

use std::fmt;
use std::ops::Deref;

/// Any error.
pub struct Error(Box<dyn std::error::Error + Send + Sync>);

impl Error {
    /// An error that is a sentence.
    pub fn msg(sentence: String) -> Self {
        Self(sentence.into())
    }

    /// The error as it was given, if it is of this type.
    ///
    /// # Errors
    /// The error, where it is of another type.
    pub fn downcast<E: std::error::Error + 'static>(self) -> Result<E, Self> {
        self.0.downcast().map(|error| *error).map_err(Self)
    }
}

impl Deref for Error {
    type Target = dyn std::error::Error + Send + Sync;

    fn deref(&self) -> &Self::Target {
        &*self.0
    }
}

impl<E: std::error::Error + Send + Sync + 'static> From<E> for Error {
    fn from(error: E) -> Self {
        Self(Box::new(error))
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Returns with a sentence as the error.
#[macro_export]
macro_rules! bail {
    ($($sentence:tt)+) => {
        return Err($crate::Error::msg(format!($($sentence)+)))
    };
}

/// Returns with a sentence as the error, unless something holds.
#[macro_export]
macro_rules! ensure {
    ($holds:expr, $($sentence:tt)+) => {
        if !$holds {
            $crate::bail!($($sentence)+);
        }
    };
}

#[cfg(test)]
mod tests {
    use super::Error;

    fn half(number: u32) -> Result<u32, Error> {
        ensure!(number.is_multiple_of(2), "{number} is odd");
        if number > 9 {
            bail!("more than {}", 9);
        }
        let read: u32 = number.to_string().parse()?;
        Ok(read / 2)
    }

    #[test]
    fn errors_say_what_they_were_given() {
        assert_eq!(half(4).unwrap_or_default(), 2);
        assert_eq!(half(3).unwrap_err().to_string(), "3 is odd");
        assert_eq!(format!("{:?}", half(12).unwrap_err()), "more than 9");
        let error = "x".parse::<u32>().map_err(Error::from).unwrap_err();
        assert_eq!(error.to_string(), "invalid digit found in string");
        assert!(error.source().is_none());
        let error = error.downcast::<std::fmt::Error>().unwrap_err();
        assert!(error.downcast::<std::num::ParseIntError>().is_ok());
    }
}
