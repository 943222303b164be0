using RayTracer.Session;
using static RayTracer.Studio.DocumentEndpoints;

namespace RayTracer.Studio;

/// <summary>Starts what is rendered into files beside the user's work.</summary>
internal static class BackgroundEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapBackground(this RouteGroupBuilder api, StudioSession session)
    {
        RouteGroupBuilder background = api.MapGroup("/background");
        background.MapPost("/part", (PartRequest r) => Started(session, session.Background.Part(r.Number, r.Count, Needed(r.Path, "path"), r.Overwrite)));
        background.MapPost("/frames", (FramesRequest r) => Started(session, session.Background.Frames(r.First, r.Last, Needed(r.Path, "path"), r.Overwrite)));
        background.MapPost("/merge", (MergeRequest r) => Started(session, session.Background.Merge(Needed(r.Parts, "parts"), Needed(r.Path, "path"), r.Overwrite)));
    }

    private static IResult Started(StudioSession session, int job) => Answers.Json(new { job, revision = session.Document.Revision });

    internal sealed record PartRequest(int Number, int Count, string? Path, bool Overwrite = false);

    internal sealed record FramesRequest(int First, int Last, string? Path, bool Overwrite = false);

    internal sealed record MergeRequest(string[]? Parts, string? Path, bool Overwrite = false);
}
