//! One component of Yew for all function components of the page.
//!
//! Yew compiles the life of a component, from its creation to its end, anew for each type
//! of component: some 5 kB of Wasm each, which for fifty components was a tenth of the
//! page. Here a single component runs the function of any other one, so that its life is
//! compiled once. Components that are there by the hundreds, and those with children, stay
//! components of their own.

use std::any::Any;
use std::rc::Rc;

use yew::functional::{FunctionProvider, Hook, HookContext};
use yew::html::HtmlResult;
use yew::prelude::*;
use yew::virtual_dom::Key;

/// A component that is shown by [`Part`].
///
/// ```ignore
/// html! { { part::<Board>(BoardProps { state, send }) } }
/// ```
pub(crate) fn part<C>(props: C::Properties) -> Html
where
    C: FunctionProvider + 'static,
    C::Properties: 'static,
{
    html! { <Part run={run::<C> as Run} props={AnyProps(Rc::new(props))} /> }
}

/// The same with a key among its siblings.
pub(crate) fn keyed_part<C>(key: impl Into<Key>, props: C::Properties) -> Html
where
    C: FunctionProvider + 'static,
    C::Properties: 'static,
{
    html! { <Part key={key.into()} run={run::<C> as Run} props={AnyProps(Rc::new(props))} /> }
}

/// The function of a component, with properties of its own type behind `dyn Any`.
type Run = fn(&mut HookContext, &dyn Any) -> HtmlResult;

fn run<C>(context: &mut HookContext, props: &dyn Any) -> HtmlResult
where
    C: FunctionProvider,
    C::Properties: 'static,
{
    match props.downcast_ref() {
        Some(props) => C::run(context, props),
        // Both are made together in `part`.
        None => Ok(Html::default()),
    }
}

/// Properties of some component, compared by their own type.
trait Compared {
    fn is_same(&self, other: &dyn Any) -> bool;
    fn any(&self) -> &dyn Any;
}

impl<T: PartialEq + 'static> Compared for T {
    fn is_same(&self, other: &dyn Any) -> bool {
        other.downcast_ref().is_some_and(|other| self == other)
    }

    fn any(&self) -> &dyn Any {
        self
    }
}

#[derive(Clone)]
struct AnyProps(Rc<dyn Compared>);

#[derive(Clone, Properties)]
struct PartProps {
    run: Run,
    props: AnyProps,
}

impl PartialEq for PartProps {
    fn eq(&self, other: &Self) -> bool {
        let (one, two) = (&self.props.0, &other.props.0);
        std::ptr::fn_addr_eq(self.run, other.run)
            && (Rc::ptr_eq(one, two) || one.is_same(two.any()))
    }
}

/// Where another component comes into the place of one, its hooks begin anew: the root of
/// a component heeds its key.
#[component]
fn Part(props: &PartProps) -> Html {
    let key = props.run as usize;
    html! { <Running {key} run={props.run} props={props.props.clone()} /> }
}

#[component]
fn Running(props: &PartProps) -> HtmlResult {
    use_part(props)
}

/// The hooks of the component that is run.
fn use_part(props: &PartProps) -> PartHook<'_> {
    PartHook(props)
}

struct PartHook<'a>(&'a PartProps);

impl Hook for PartHook<'_> {
    type Output = HtmlResult;

    fn run(self, context: &mut HookContext) -> HtmlResult {
        (self.0.run)(context, self.0.props.0.any())
    }
}
