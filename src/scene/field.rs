//! What can stand for a key: each type of a scene's fields read from a value, and written as one.

use super::keys::{Key, SOLID_KEYS, STEP_KEYS};
use super::value::{Entry, Item, Value, whole_of};
use super::{CameraFile, Layout, PartKind, SolidFile, StepFile, Theme, TimeUnit, read};
use crate::physics::number;

/// What kind of value a key takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A text.
    Text,
    /// A number.
    Number,
    /// So many numbers.
    Numbers(usize),
    /// A whole number.
    Whole,
    /// A principal axis.
    Axis,
    /// On or off.
    Switch,
    /// One of these names.
    Choice(&'static [&'static str]),
    /// Any number of names.
    Names,
    /// Principal axes.
    Axes,
    /// Solids, each a table.
    Solids,
    /// Steps, each a table.
    Steps,
}

impl Kind {
    /// What a value must be, in the words of the file.
    #[must_use]
    pub fn words(self) -> String {
        match self {
            Self::Text => "a text in quotes".to_owned(),
            Self::Number => "a number".to_owned(),
            Self::Numbers(count) => format!("an array of {count} numbers"),
            Self::Whole => "a whole number".to_owned(),
            Self::Axis => "1 (smallest moment), 2 or 3 (largest)".to_owned(),
            Self::Switch => "true or false".to_owned(),
            Self::Choice(names) => match names.split_last() {
                Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
                _ => names.concat(),
            },
            Self::Names => "an array of names in quotes".to_owned(),
            Self::Axes => "an array of axes, each 1 (smallest moment), 2 or 3 (largest)".to_owned(),
            Self::Solids => "an array of solids, one at least".to_owned(),
            Self::Steps => "an array of steps, each a table [[step]]".to_owned(),
        }
    }
}

/// Why a text is no scene: what is wrong, and at which byte.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Wrong {
    /// First byte of what is wrong.
    pub(super) start: usize,
    /// One sentence.
    pub(super) message: String,
}

/// Why a value is not taken.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Refused {
    /// It is of another kind: what it is instead, after "is", and where.
    Kind(String, usize),
    /// Something in it is wrong.
    Wrong(Wrong),
}

impl Refused {
    /// The value is of another kind.
    fn other(item: &Item) -> Self {
        Self::Kind(item.value.described(), item.start)
    }
}

/// A type that one value stands for.
pub(super) trait Single: Sized {
    /// What kind of value.
    const KIND: Kind;
    /// What kind of array is an array of these.
    const MANY: Kind = Kind::Names;
    /// Reads it.
    fn read(item: &Item) -> Result<Self, Refused>;
    /// Writes it.
    fn write(&self) -> Value;
}

impl Single for String {
    const KIND: Kind = Kind::Text;
    fn read(item: &Item) -> Result<Self, Refused> {
        match &item.value {
            Value::Text(text) => Ok(text.clone()),
            _ => Err(Refused::other(item)),
        }
    }
    fn write(&self) -> Value {
        Value::Text(self.clone())
    }
}

impl Single for f64 {
    const KIND: Kind = Kind::Number;
    fn read(item: &Item) -> Result<Self, Refused> {
        match item.value {
            Value::Number(value) => Ok(value),
            Value::Whole(value) => Ok(value as Self),
            _ => Err(Refused::other(item)),
        }
    }
    fn write(&self) -> Value {
        Value::Number(*self)
    }
}

impl<const N: usize> Single for [f64; N] {
    const KIND: Kind = Kind::Numbers(N);
    fn read(item: &Item) -> Result<Self, Refused> {
        let numbers: Vec<f64> = array(item)?;
        numbers.try_into().map_err(|_| Refused::other(item))
    }
    fn write(&self) -> Value {
        Value::List(self.iter().map(|number| number.write().into()).collect())
    }
}

impl Single for i64 {
    const KIND: Kind = Kind::Whole;
    fn read(item: &Item) -> Result<Self, Refused> {
        match item.value {
            Value::Whole(value) => Ok(value),
            // `1e5` is whole too, and so is 1e300, of which it is not what is wrong.
            Value::Number(value) => whole_of(value).ok_or_else(|| {
                let beyond = Value::Beyond(number(value)).described();
                if value.fract() == 0.0 { Refused::Kind(beyond, item.start) } else { Refused::other(item) }
            }),
            _ => Err(Refused::other(item)),
        }
    }
    fn write(&self) -> Value {
        Value::Whole(*self)
    }
}

/// The one small whole number of a scene is an axis.
impl Single for u8 {
    const KIND: Kind = Kind::Axis;
    const MANY: Kind = Kind::Axes;
    fn read(item: &Item) -> Result<Self, Refused> {
        match i64::read(item)? {
            axis @ 1..=3 => Ok(axis as Self),
            _ => Err(Refused::other(item)),
        }
    }
    fn write(&self) -> Value {
        Value::Whole(i64::from(*self))
    }
}

impl Single for bool {
    const KIND: Kind = Kind::Switch;
    fn read(item: &Item) -> Result<Self, Refused> {
        match item.value {
            Value::Switch(is_on) => Ok(is_on),
            _ => Err(Refused::other(item)),
        }
    }
    fn write(&self) -> Value {
        Value::Switch(*self)
    }
}

/// The names of a type's values, in the order in which they are listed.
macro_rules! choice {
    ($type:ty: $($name:literal = $value:path),+) => {
        impl Single for $type {
            const KIND: Kind = Kind::Choice(&[$($name),+]);
            fn read(item: &Item) -> Result<Self, Refused> {
                match &item.value {
                    Value::Text(name) => match name.as_str() {
                        $($name => Ok($value),)+
                        _ => Err(Refused::other(item)),
                    },
                    _ => Err(Refused::other(item)),
                }
            }
            fn write(&self) -> Value {
                Value::Text(match self { $($value => $name),+ }.to_owned())
            }
        }
    };
}

choice!(Layout: "both" = Layout::Both, "world" = Layout::World, "body" = Layout::Body);
choice!(Theme: "dark" = Theme::Dark, "light" = Theme::Light);
choice!(TimeUnit: "s" = TimeUnit::Second, "d" = TimeUnit::Day);
choice!(PartKind: "box" = PartKind::Box, "cylinder" = PartKind::Cylinder, "ellipsoid" = PartKind::Ellipsoid);

impl Single for SolidFile {
    const KIND: Kind = Kind::Solids;
    const MANY: Kind = Kind::Solids;
    fn read(item: &Item) -> Result<Self, Refused> {
        match &item.value {
            Value::Table(entries) => read::solid(entries, item.start).map_err(Refused::Wrong),
            _ => Err(Refused::other(item)),
        }
    }
    fn write(&self) -> Value {
        let entry =
            |key: &Key<Self>| Some(Entry { key: key.own_name().to_owned(), start: 0, item: key.get(self)?.into() });
        Value::Table(SOLID_KEYS.iter().filter_map(entry).collect())
    }
}

impl Single for StepFile {
    const KIND: Kind = Kind::Steps;
    const MANY: Kind = Kind::Steps;
    fn read(item: &Item) -> Result<Self, Refused> {
        match &item.value {
            Value::Table(entries) => read::step(entries).map_err(Refused::Wrong),
            _ => Err(Refused::other(item)),
        }
    }
    fn write(&self) -> Value {
        // A camera by its keys one by one: `world_camera.distance`.
        let own_name = |key: &Key<Self>| key.name.strip_prefix("step.").unwrap_or(key.name).to_owned();
        let entry = |key: &Key<Self>| Some(Entry { key: own_name(key), start: 0, item: key.get(self)?.into() });
        Value::Table(STEP_KEYS.iter().filter(|key| !key.is_short).filter_map(entry).collect())
    }
}

/// The values of an array, each of them read.
fn array<T: Single>(item: &Item) -> Result<Vec<T>, Refused> {
    let Value::List(items) = &item.value else { return Err(Refused::other(item)) };
    let read = |part: &Item| {
        T::read(part).map_err(|refused| match refused {
            Refused::Kind(what, start) => Refused::Kind(format!("an array with {what} in it"), start),
            Refused::Wrong(wrong) => Refused::Wrong(wrong),
        })
    };
    items.iter().map(read).collect()
}

/// A field of a scene: what may be left out.
pub(super) trait Field: Default {
    /// What kind of value it takes.
    const KIND: Kind;
    /// What stands there; nothing where it is left out.
    fn get(&self) -> Option<Value>;
    /// Reads it.
    fn read(item: &Item) -> Result<Self, Refused>;
}

impl<T: Single> Field for Option<T> {
    const KIND: Kind = T::KIND;
    fn get(&self) -> Option<Value> {
        self.as_ref().map(Single::write)
    }
    fn read(item: &Item) -> Result<Self, Refused> {
        T::read(item).map(Some)
    }
}

/// An empty text is none.
impl Field for String {
    const KIND: Kind = Kind::Text;
    fn get(&self) -> Option<Value> {
        (!self.is_empty()).then(|| self.write())
    }
    fn read(item: &Item) -> Result<Self, Refused> {
        <Self as Single>::read(item)
    }
}

/// No entries are none; only of names may an array be empty.
impl<T: Single> Field for Vec<T> {
    const KIND: Kind = T::MANY;
    fn get(&self) -> Option<Value> {
        (!self.is_empty()).then(|| Value::List(self.iter().map(|part| part.write().into()).collect()))
    }
    fn read(item: &Item) -> Result<Self, Refused> {
        let parts = array(item)?;
        if parts.is_empty() && !matches!(T::MANY, Kind::Names | Kind::Steps) {
            Err(Refused::other(item))
        } else {
            Ok(parts)
        }
    }
}

/// What every solid has.
macro_rules! always {
    ($($type:ty),+) => {
        $(impl Field for $type {
            const KIND: Kind = <$type as Single>::KIND;
            fn get(&self) -> Option<Value> {
                Some(self.write())
            }
            fn read(item: &Item) -> Result<Self, Refused> {
                <$type as Single>::read(item)
            }
        })+
    };
}

always!(PartKind, f64, [f64; 3]);

/// A camera in short: azimuth, elevation, distance and the point looked at, where all of them are given.
impl Field for CameraFile {
    const KIND: Kind = Kind::Numbers(6);
    fn get(&self) -> Option<Value> {
        let [x, y, z] = self.target?;
        Some([self.azimuth_deg?, self.elevation_deg?, self.distance?, x, y, z].write())
    }
    fn read(item: &Item) -> Result<Self, Refused> {
        let [azimuth_deg, elevation_deg, distance, x, y, z] = <[f64; 6]>::read(item)?;
        Ok(Self {
            azimuth_deg: Some(azimuth_deg),
            elevation_deg: Some(elevation_deg),
            distance: Some(distance),
            target: Some([x, y, z]),
        })
    }
}
