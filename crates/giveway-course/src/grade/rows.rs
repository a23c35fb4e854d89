//! The rows of a class's table: who handed in, in which order, and which file counts.

use super::{Claim, Class, Filed, Graded};

/// In which order rows stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Order {
    /// Whom to look at first: a claim that is false, then fewest solved, then the name.
    #[default]
    LookAtFirst,
    /// By name; those without one at the end.
    Name,
}

/// Somebody who handed a lesson in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Student {
    /// The lesson, by its place.
    lesson: usize,
    /// The name, in the form in which it is compared; those without one stay apart.
    key: Option<String>,
    /// All files of that name, by their places.
    files: Vec<usize>,
    /// The one that counts.
    pub(super) counts: usize,
}

impl Student {
    /// Puts a file that is added at a place beside those of its name: the later one counts,
    /// by the date; where one has no date, or both are equal, the one that is added last.
    pub(super) fn enroll(students: &mut Vec<Self>, files: &[Filed], filed: &Filed, place: usize) {
        let Ok(content) = &filed.content else {
            return;
        };
        let lesson = content.lesson;
        let key = content.hand_in.name.as_deref().map(key);
        let is_same =
            |other: &&mut Self| key.is_some() && other.key == key && other.lesson == lesson;
        let Some(student) = students.iter_mut().find(is_same) else {
            let files = vec![place];
            students.push(Self {
                lesson,
                key,
                files,
                counts: place,
            });
            return;
        };
        student.files.push(place);
        let date = files.get(student.counts).and_then(|file| file.date);
        let is_older = date.zip(filed.date).is_some_and(|(kept, new)| new < kept);
        if !is_older {
            student.counts = place;
        }
    }
}

/// A name as it is compared: blanks and capitals tell nobody apart.
fn key(name: &str) -> String {
    let words: Vec<&str> = name.split_whitespace().collect();
    words.join(" ").to_lowercase()
}

/// A row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    student: &'a Student,
    place: usize,
    file: &'a Filed,
}

impl<'a> Row<'a> {
    /// The name, as the file has it; `None` where it has none.
    pub fn name(&self) -> Option<&'a str> {
        self.file.hand_in().and_then(|it| it.name.as_deref())
    }

    /// The name, else that of the file.
    pub fn title(&self) -> &'a str {
        self.name().unwrap_or(&self.file.file)
    }

    /// The file: the one that counts, in a table.
    pub const fn file(&self) -> &'a Filed {
        self.file
    }

    /// All files of that name, by their places among [`Class::files`].
    pub fn files(&self) -> &'a [usize] {
        &self.student.files
    }

    /// The place of the file.
    pub const fn place(&self) -> usize {
        self.place
    }

    /// The tasks, in the order of the lesson.
    pub fn tasks(&self) -> &'a [Graded] {
        self.file.tasks()
    }

    /// How many tasks are judged to be solved.
    pub fn solved(&self) -> usize {
        self.tasks().iter().filter(|task| task.is_solved()).count()
    }

    /// Whether the file says of a task that it is solved, and it is not.
    pub fn is_false(&self) -> bool {
        let mut tasks = self.tasks().iter();
        tasks.any(|task| task.claim() == Claim::False)
    }
}

impl Class {
    /// The rows of a lesson, by its place among [`Class::lessons`].
    pub fn rows(&self, lesson: usize, order: Order) -> Vec<Row<'_>> {
        let students = self.students.iter();
        let students = students.filter(|student| student.lesson == lesson);
        let mut rows: Vec<Row<'_>> = students
            .filter_map(|student| {
                let file = self.files.get(student.counts)?;
                let place = student.counts;
                Some(Row {
                    student,
                    place,
                    file,
                })
            })
            .collect();
        let name = |row: &Row<'_>| (row.name().is_none(), natural(row.title()), row.place());
        match order {
            Order::Name => rows.sort_by_cached_key(name),
            Order::LookAtFirst => {
                rows.sort_by_cached_key(|row| (!row.is_false(), row.solved(), name(row)));
            }
        }
        rows
    }

    /// The row of a file, by its place among [`Class::files`]; also of one that another file
    /// of its name has taken the place of.
    pub fn row(&self, place: usize) -> Option<Row<'_>> {
        let student = self.students.iter().find(|it| it.files.contains(&place))?;
        let file = self.files.get(place)?;
        Some(Row {
            student,
            place,
            file,
        })
    }

    /// The lessons of which there are hand-ins, by their places.
    pub fn tables(&self) -> Vec<usize> {
        let lessons = 0..self.lessons().len();
        let has_rows = |lesson: &usize| self.students.iter().any(|it| it.lesson == *lesson);
        lessons.filter(has_rows).collect()
    }
}

/// A name for sorting: numbers in it by their size, so that 9 stands before 10.
fn natural(name: &str) -> Vec<(String, u64)> {
    let mut parts: Vec<(String, u64)> = vec![(String::new(), 0)];
    let mut was_digit = false;
    for c in key(name).chars() {
        let digit = c.to_digit(10);
        if was_digit && digit.is_none() {
            parts.push((String::new(), 0));
        }
        was_digit = digit.is_some();
        if let Some((words, number)) = parts.last_mut() {
            match digit {
                Some(digit) => *number = number.saturating_mul(10).saturating_add(digit.into()),
                None => words.push(c),
            }
        }
    }
    parts
}
