//! Files of every format that are read: whole ones, to be damaged.

/// A map of a standard benchmark, for plans that need one.
pub(crate) const MAP: &str = "type octile\nheight 3\nwidth 4\nmap\n....\n.@..\n....\n";

/// Two robots on it.
pub(crate) const SCENARIO: &str =
    "version 1\n0\tm.map\t4\t3\t0\t0\t3\t0\t3\n0\tm.map\t4\t3\t3\t2\t0\t2\t3\n";

/// The files, format by format.
pub(crate) const SEEDS: &[&str] = &[
    MAP,
    SCENARIO,
    // The project's own.
    r##"{ "giveway": 1, "name": "n", "map": ["..~~", "#+*."], "agents": [
        { "name": "A", "start": [0, 0], "goal": [1, 1] }] }"##,
    r#"{ "giveway": 1, "paths": { "A": [[0, 0], null, [1, 0], [1, 1]] }, "knows": 1 }"#,
    // The MAPF tracker.
    "agents,lower_cost,solution_cost,path\n\"2\",\"6\",\"6\",\"3r\n3l\"\n",
    "map_name,scen_type,type_id,agents,solution_plan,flip_up_down\n\
     \"m\",even,0,2,\"2r1wr\r\nlll\",FALSE\r\nm,even,0,2,,TRUE\r\n",
    r#"[{ "map_name": "m", "scen_type": "even", "type_id": 0, "agents": 2,
        "solution_plan": "3r\n3l" }, { "agents": 1, "solution_plan": ["u"] }]"#,
    "---\nmap_name: \"m\"\nagents: 2\nsolution_plan:\n  - 3r\n  - 'lll'\n---\n\
     agents: 2\nflip_up_down: true\nsolution_plan: |\n  u\n  2dw\n",
    // CBSH2-RTC and its kin.
    "Agent 0: (0,0)->(0,1)->(0,2)->(0,3)->\nAgent 1: (2,3)->(2,2)->(2,1)->(2,0)->\n",
    "Agent 0:(0,0)->(1,0)->\r\nAgent 1:\r\n",
    // LaCAM and its kin.
    "agents=2\nmap_file=m.map\nsolver=planner\nsolved=1\nsoc=6\nmakespan=3\n\
     starts=(0,0),(3,2),\ngoals=(3,0),(0,2),\nsolution=\n0:(0,0),(3,2),\n1:(1,0),(2,2),\n",
    "0:(0,0,X_PLUS),(3,2,Y_MINUS),\n1:(1,0,X_PLUS),(2,2,X_MINUS)",
    "agents=1\ntask=\n0:12->13,appear=0,finished=2\nsolution=\n0:(0,0)->(2,3):-1,\n",
    // libMultiRobotPlanning.
    "map:\n  dimensions: [4, 3]\n  obstacles:\n    - [1, 1]\nagents:\n  - name: a\n    \
     start: [0, 0]\n    goal: [3, 0]\n  - name: b\n    start: [3, 2]\n    potentialGoals: \
     [[0, 2], [3, 2]]\n",
    "statistics:\n  cost: 6\n  makespan: 3\n  runtime: 0.01\nschedule:\n  agent0:\n    - x: 0\n      \
     y: 0\n      t: 0\n    - x: 1\n      y: 0\n      t: 2\n  agent1:\n    - x: 3\n      y: 2\n      t: 0\n",
    "map: {dimensions: [2, 1], obstacles: []}\nagents: [{start: [0, 0], goal: [1, 0]}]\n\
     schedule: {agent0: [{x: 0, y: 0, t: 0}, {x: 1, y: 0, t: 1}]}\n",
    // The League of Robot Runners.
    r#"{"actionModel": "MAPF_T", "AllValid": "No", "teamSize": 2, "makespan": 4, "sumOfCost": 8,
        "start": [[0, 0, "E"], [2, 3, "W"]], "actualPaths": ["F,F,R,W", "F,C,F,T"],
        "plannerPaths": ["F,F,R,W", "F,C,F,T"], "errors": [[0, 1, 2, "vertex conflict"]],
        "events": [[[0, 0, "assigned"], [0, 2, "finished"]], []], "tasks": [[0, 0, 2], [1, 2, 0]]}"#,
    r#"{"actionModel": "MAPF", "version": "2024 LoRR", "start": [[0, 0, "N/A"], [2, 3, "S", "W"]],
        "actualPaths": ["R,R,W,", "L,L,U"], "errors": [], "scheduleErrors": [],
        "events": [[1, 0, 7, 1], [2, 0, 7, 2], [3, 1, 8, 0]],
        "tasks": [[7, 0, [0, 1, 0, 2]], [8, 2, [0, 0]]]}"#,
    r#"{"actionModel": "MAPF_T", "version": "2026 LoRR", "agentMaxCounter": 2, "start": [[0, 0, "E"]],
        "actualPaths": ["[(0,0,0,0,0):(F 2,W 1)][(3,0,1,0,0):(R 2,F 2)]"],
        "events": [[2, 0, 0, 1]], "tasks": [[0, 0, [0, 1]]]}"#,
    // asprilo.
    "init(object(node,1),value(at,(1,1))). init(object(node,2),value(at,(2,1))).\n\
     init(object(node,3),value(at,(3,1))). %* a pocket *%\ninit(object(node,4),value(at,(2,2))).\n\
     init(object(robot,1),value(at,(1,1))). init(object(robot,2),value(at,(3,1))).\n\
     occurs(object(robot,1),action(move,(1,0)),1). % east\n\
     occurs(object(robot,1),action(move,(0,1)),2). occurs(object(robot,2),action(move,(-1,0)),3).\n",
    "init(object(node,1),value(at,(1,1))). init(object(node,2),value(at,(2,1))).\n\
     init(object(robot,1),value(at,(1,1))). init(object(shelf,1),value(at,(2,1))).\n\
     init(object(product,1),value(on,(1,5))). init(object(pickingStation,1),value(at,(1,1))).\n\
     init(object(order,1),value(line,(1,1))). init(object(order,1),value(pickingStation,1)).\n\
     occurs(object(robot,1),action(move,(1,0)),1). occurs(object(robot,1),action(pickup,()),2).\n\
     occurs(object(robot,1),action(move,(-1,0)),3). occurs(object(robot,1),action(deliver,(1,1,1)),4).\n",
    "#include \"a.lp\". #const horizon=3.\noccurs(object(robot,2),action(move,(-1,0)),2).",
    "clingo version 5.7.1\nReading from m.lp\nSolving...\nAnswer: 1\ninit(object(node,1),value(at,(1,1))) \
     init(object(robot,1),value(at,(1,1)))\nOptimization: 3\nOPTIMUM FOUND\n\nModels : 1\n",
    // The class project.
    "2 3\n. . .\n. @ .\n2\n0 0 1 2\n1 0 0 2\n",
    "3 4\r\n....\r\n.@..\r\n....\r\n1\r\n0 0 2 3",
    "4 5\n.....\n.....\n.....\n.....\n3\n0 0 3 3\n1 1 2 2\n2 0 0 2\n",
    "2 3\n...\n.@.\n",
    // A bare grid.
    "a..B\n.#..\nb..A\n",
    "0 0 1 0\n0 1 0 0\n0 0 0 0\n",
    "S.@.\n...G",
    // mapfw.nl and mapf.nl.
    r#"{"grid": [[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]], "width": "4", "height": 3,
        "starts": [[0, 0], [3, 2]], "goals": [[3, 0], [0, 2]], "waypoints": [[[1, 0]], []],
        "solution": [[[0, 0], [1, 0], [2, 0], [3, 0]], [[3, 2], [2, 2], [1, 2], [0, 2]]]}"#,
    r#"{"grid": [[0, 0, 0]], "starts": [{"x": 0, "y": 0, "color": 1}, {"x": 1, "y": 0, "color": 2}],
        "goals": [{"x": 2, "y": 0, "color": 2}, {"x": 1, "y": 0, "color": 1}]}"#,
    r#"{"attempt": 7, "problems": [{"id": 1, "problem":
        "{\"grid\": [[0, 0]], \"starts\": [[0, 0]], \"goals\": [[1, 0]]}"}, {"id": 2, "problem": "{}"}]}"#,
    r#"{"solutions": [{"problem": 1, "solution": {"paths": [{"route": [{"x": 0, "y": 0}, {"x": 1, "y": 0}]}]}}]}"#,
    "[[[0, 0], [1, 0]], [[3, 2]]]",
];
