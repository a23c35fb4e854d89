//! The report of the plan, to be read, printed and saved.

use giveway_model::tr;
use giveway_page::files::Saved;
use giveway_page::report;
use wasm_bindgen::JsValue;
use yew::prelude::*;

use super::frame::Frame;
use crate::{Shown, files, icon, keep, language};

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct ReportProps {
    /// The state.
    pub(crate) state: Shown,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
}

/// The report, below what can be done with it.
#[component]
pub(crate) fn Report(props: &ReportProps) -> Html {
    let ReportProps { state, on_close } = props;
    let save = |make: fn(&Shown) -> Option<Saved>| {
        let state = state.clone();
        move |_: MouseEvent| {
            if let Some(saved) = make(&state) {
                files::save(&saved);
            }
        }
    };
    let print = |_: MouseEvent| {
        // A browser may print nothing; then nothing happens.
        let _ = gloo::utils::window().print();
    };
    // Until then it would lack who makes whom late.
    let disabled = report::is_coming(state);
    let button = |icon: &'static str, name: &'static str, onclick: Callback<MouseEvent>| {
        html! { <button type="button" class="btn outline" {disabled} {onclick}>{ icon::show(icon) }{ name }</button> }
    };
    html! {
        <Frame title={tr!("Report")} on_close={on_close.clone()}>
            <div class="report-tools" role="toolbar" aria-label={tr!("Report")}>
                { button("file", tr!("Print, or save as PDF"), Callback::from(print)) }
                { button("save", tr!("Save the report (HTML)"), Callback::from(save(|state| report::report_file(state, imprint(state), language::spoken())))) }
                { button("save", tr!("Save the plan (CSV)"), Callback::from(save(|state| report::plan_csv_file(state)))) }
                { button("save", tr!("Save the arrivals (CSV)"), Callback::from(save(|state| report::arrivals_csv_file(state)))) }
            </div>
            <p class="report-coming" role="status">{ disabled.then(|| tr!("Adding up who costs whom.")) }</p>
            { sheet(state) }
        </Frame>
    }
}

/// The report itself. Names in it cannot be markup: `Report::html` escapes them.
pub(crate) fn sheet(state: &Shown) -> Html {
    let html = report::report(state, imprint(state)).map(|report| report.html());
    Html::from_html_unchecked(html.unwrap_or_default().into())
}

/// Where and when the report is made.
fn imprint(state: &Shown) -> report::Imprint {
    let today = js_sys::Date::new_0();
    let date = today.to_locale_date_string(language::spoken(), &JsValue::UNDEFINED);
    report::Imprint {
        address: Some(keep::address_of_plan(state)),
        date: Some(date.into()),
    }
}
