import type {
  AuditAnswer, AuditRequest, CertifyRequest, ChangeAnswer, ChangeRequest, CheckAnswer, CheckRequest, CompareRequest,
  Comparison, ConvertAnswer, ConvertRequest, DelaysAnswer, DelaysRequest, ExplainAnswer, ExplainRequest, Exported, Files, FreedomAnswer,
  FreedomRequest, FrontAnswer, OrderAnswer, OrderRequest,
  PlanAnswer, PlanRequest, PriceAnswer, PriceRequest, Progress, ReadOptions, Report, Schema, SizingAnswer, SizingRequest, SolveAnswer, SolveRequest, TogetherAnswer, TogetherRequest,
  VerifyRequest,
} from "./types.js";

export * from "./types.js";

export interface Waiting {
  /** Ends it at once; the promise is then rejected with the signal's reason. */
  signal?: AbortSignal;
  /** Told what becomes known on the way. */
  onProgress?: (event: Progress) => void;
}

/** The solver in a worker of its own: the page never waits for it. */
export class Giveway {
  /** @param start starts a worker that runs `giveway/worker/solver` */
  constructor(start?: () => Worker);
  solve(request: SolveRequest & { pareto?: false }, waiting?: Waiting): Promise<SolveAnswer>;
  solve(request: SolveRequest & { pareto: true }, waiting?: Waiting): Promise<FrontAnswer>;
  check(request: CheckRequest, waiting?: Waiting): Promise<CheckAnswer>;
  explain(request: ExplainRequest, waiting?: Waiting): Promise<ExplainAnswer>;
  change(request: ChangeRequest, waiting?: Waiting): Promise<ChangeAnswer>;
  audit(request: AuditRequest, waiting?: Waiting): Promise<AuditAnswer>;
  freedom(request: FreedomRequest, waiting?: Waiting): Promise<FreedomAnswer>;
  price(request: PriceRequest, waiting?: Waiting): Promise<PriceAnswer>;
  delays(request: DelaysRequest, waiting?: Waiting): Promise<DelaysAnswer>;
  order(request: OrderRequest, waiting?: Waiting): Promise<OrderAnswer>;
  sizing(request: SizingRequest, waiting?: Waiting): Promise<SizingAnswer>;
  plan(request: PlanRequest, waiting?: Waiting): Promise<PlanAnswer>;
  together(request: TogetherRequest, waiting?: Waiting): Promise<TogetherAnswer>;
  compare(request: CompareRequest, waiting?: Waiting): Promise<Comparison>;
  readFiles(files: Record<string, string | Uint8Array>, options?: ReadOptions, waiting?: Waiting): Promise<Files>;
  certify(request: CertifyRequest, waiting?: Waiting): Promise<Report>;
  exportCertificates(requests: Record<string, CertifyRequest>, waiting?: Waiting): Promise<Exported>;
  verify(request: VerifyRequest, waiting?: Waiting): Promise<Report>;
  convert(request: ConvertRequest, waiting?: Waiting): Promise<ConvertAnswer>;
  schema(waiting?: Waiting): Promise<Schema>;
  /** Ends the worker; what waits is rejected with an `AbortError`. */
  close(): void;
}
