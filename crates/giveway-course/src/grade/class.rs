//! The machine: files come in, questions go out, answers come in, and the table grows.

use std::rc::Rc;

use giveway_model::Fault;
use giveway_solve::Response;

use super::Judgement;
use super::answers::{Answers, Key};
use super::filed::{Content, Filed, Unread};
use super::given::{Given, Next, Progress};
use super::limits::{FIRST_WORK, MORE};
use super::rows::Student;
use super::task::{Graded, State};
use crate::handin::{self, HandIn};
use crate::learner::AskNumber;
use crate::lesson::{Id, Lesson};

/// The hand-ins of a class. No hand-in is kept but here: when it is dropped, the names are
/// gone.
///
/// ```
/// use std::rc::Rc;
/// use giveway_course::grade::{Class, Given, Next, Order};
/// use giveway_course::handin::{HandIn, Sum, hand_in, write};
/// use giveway_course::learner::Progress;
/// use giveway_course::lesson::{Glossary, read_lesson};
/// let text = r#"{ "giveway": 1, "title": "T", "minutes": 4, "about": "A sentence.",
///   "steps": [{ "title": "One", "text": ["A sentence."],
///               "scene": { "giveway": 1, "map": ["."], "agents": [] } }] }"#;
/// let lesson = Rc::new(read_lesson(text, &Glossary::default()).unwrap());
/// let id: giveway_course::lesson::Id = "t".parse().unwrap();
/// let file = write(&hand_in(&Progress::default(), &id, &lesson, "Ada"));
/// let mut class = Class::new([Given::new(id, lesson)]);
/// class.add("t-ada.json", Some(1), &file);
/// assert_eq!(class.step(), Next::Done);
/// assert_eq!(class.rows(0, Order::Name)[0].name(), Some("Ada"));
/// ```
#[derive(Clone, Debug)]
pub struct Class {
    pub(super) lessons: Vec<Given>,
    pub(super) files: Vec<Filed>,
    pub(super) students: Vec<Student>,
    answers: Answers,
    number: AskNumber,
    asked: Option<Key>,
    work: u64,
    is_cancelled: bool,
    /// No student before this one has a task that is not judged.
    from: usize,
}

impl Class {
    /// A class without files. Of two lessons with one check sum, such as two languages of
    /// one, the first is told.
    pub fn new(lessons: impl IntoIterator<Item = Given>) -> Self {
        Self {
            lessons: lessons.into_iter().collect(),
            files: Vec::new(),
            students: Vec::new(),
            answers: Answers::default(),
            number: AskNumber::default(),
            asked: None,
            work: FIRST_WORK,
            is_cancelled: false,
            from: 0,
        }
    }

    /// The lessons that were given.
    pub fn lessons(&self) -> &[Given] {
        &self.lessons
    }

    /// All files that were added, in their order.
    pub fn files(&self) -> &[Filed] {
        &self.files
    }

    /// Lets the solver do so many units of work for a question, before anything is judged.
    pub const fn allow_work(&mut self, work: u64) {
        self.work = work;
    }

    /// Units of work that the solver may do for one question.
    pub const fn work(&self) -> u64 {
        self.work
    }

    /// Adds a lesson; files of it that were added before are known from then on.
    pub fn give(&mut self, given: Given) {
        self.lessons.push(given);
        let mut files = std::mem::take(&mut self.files);
        for file in &mut files {
            if let Err(Unread::OtherLesson { hand_in, .. }) = &file.content {
                file.content = self.content((**hand_in).clone());
            }
        }
        self.students.clear();
        for file in files {
            self.put(file);
        }
    }

    /// Tells a lesson that was given in the words of another language.
    pub fn reword(&mut self, id: &Id, lesson: &Rc<Lesson>) {
        for given in self.lessons.iter_mut().filter(|given| given.id == *id) {
            given.lesson = Rc::clone(lesson);
        }
    }

    /// Adds a file, or a link, by its name, its date, and its text.
    pub fn add(&mut self, file: &str, date: Option<u64>, text: &str) {
        let content = match handin::read(text) {
            Ok(hand_in) => self.content(hand_in),
            Err(fault) => Err(Unread::Fault(fault)),
        };
        let file = file.to_owned();
        self.put(Filed {
            file,
            date,
            content,
        });
    }

    /// Adds a file that cannot be read as a text, and why.
    pub fn add_unreadable(&mut self, file: &str, fault: Fault) {
        self.put(Filed {
            file: file.to_owned(),
            date: None,
            content: Err(Unread::Fault(fault)),
        });
    }

    fn content(&self, hand_in: HandIn) -> Result<Content, Unread> {
        let of = &hand_in.hand_in;
        let lesson = self.lessons.iter().position(|it| it.sum == of.sum);
        let Some(lesson) = lesson else {
            return Err(Unread::OtherLesson {
                is_edition: self.lessons.iter().any(|it| it.id == of.lesson),
                hand_in: Box::new(hand_in),
            });
        };
        let given = self.lessons.get(lesson);
        let steps: Vec<usize> = given.map_or_else(Vec::new, |given| given.tasks().collect());
        // Work for a step without a task is judged, too: it may claim something.
        let others = hand_in.tasks.iter().map(|work| work.step);
        let others = others
            .filter(|step| !steps.contains(step))
            .collect::<Vec<_>>();
        let steps = steps.iter().chain(&others);
        let graded = |step: &usize| Graded::new(*step, hand_in.work(*step).cloned());
        Ok(Content {
            tasks: steps.map(graded).collect(),
            lesson,
            hand_in,
        })
    }

    fn put(&mut self, filed: Filed) {
        let place = self.files.len();
        Student::enroll(&mut self.students, &self.files, &filed, place);
        self.files.push(filed);
        self.from = 0;
    }

    /// Judges on: up to the next question for the solver, or to the next task. The question
    /// that is open is asked again until it is answered.
    pub fn step(&mut self) -> Next {
        if self.is_cancelled {
            return Next::Done;
        }
        while let Some(student) = self.students.get(self.from) {
            let file = self.files.get_mut(student.counts);
            let content = file.and_then(|file| file.content.as_mut().ok());
            let Some(content) = content else {
                self.from += 1;
                continue;
            };
            let lesson = self.lessons.get(content.lesson);
            let mut tasks = content.tasks.iter_mut();
            let open = tasks.find(|task| task.judgement().is_none());
            let (Some(given), Some(task)) = (lesson, open) else {
                self.from += 1;
                continue;
            };
            let Some(key) = task.step(&given.lesson, self.work, &mut self.answers) else {
                return Next::Again;
            };
            if self.asked != Some(key) {
                self.number.0 = self.number.0.wrapping_add(1);
                self.asked = Some(key);
            }
            if let Some(request) = self.answers.open(key) {
                let request = Box::new(request.clone());
                let number = self.number;
                return Next::Ask { number, request };
            }
            return Next::Again;
        }
        Next::Done
    }

    /// The solver has answered; an answer to an earlier question is dropped.
    pub fn answered(&mut self, number: AskNumber, response: Response) {
        if let Some(key) = self.asked.take_if(|_| number == self.number) {
            self.answers.answer(key, response);
        }
    }

    /// The solver broke down at a question, as a sentence: what needs it is not decided.
    pub fn failed(&mut self, number: AskNumber, sentence: String) {
        if let Some(key) = self.asked.take_if(|_| number == self.number) {
            self.answers.fail(key, sentence);
        }
    }

    /// Stops. What is judged stays.
    pub fn cancel(&mut self) {
        self.is_cancelled = true;
        self.asked = None;
    }

    /// Whether it was stopped before all was judged.
    pub fn is_cancelled(&self) -> bool {
        let progress = self.progress();
        self.is_cancelled && progress.done < progress.all
    }

    /// Goes on after it was stopped, and with what is not decided: the solver may do ten
    /// times as much for that.
    pub fn go_on(&mut self) {
        self.is_cancelled = false;
        self.from = 0;
        self.answers.forget_failures();
        let contents = self.files.iter_mut();
        let contents = contents.filter_map(|file| file.content.as_mut().ok());
        let mut is_more = false;
        for task in contents.flat_map(|content| &mut content.tasks) {
            if matches!(&task.state, State::Judged(Judgement::Undecided(_))) {
                task.state = State::Waiting;
                is_more = true;
            }
        }
        if is_more {
            self.work = self.work.saturating_mul(MORE);
        }
    }

    /// How much is judged of the hand-ins that count.
    pub fn progress(&self) -> Progress {
        let counted = self.students.iter();
        let files = counted.filter_map(|student| self.files.get(student.counts));
        let mut progress = Progress::default();
        for task in files.flat_map(Filed::tasks) {
            progress.all += 1;
            progress.done += usize::from(task.judgement().is_some());
        }
        progress
    }

    /// How many claims of the hand-ins that count are false.
    pub fn false_claims(&self) -> usize {
        let counted = self.students.iter();
        let files = counted.filter_map(|student| self.files.get(student.counts));
        let tasks = files.flat_map(Filed::tasks);
        tasks
            .filter(|task| task.claim() == super::Claim::False)
            .count()
    }
}
