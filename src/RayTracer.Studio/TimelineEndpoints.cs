using RayTracer.Description;
using RayTracer.Session;
using static RayTracer.Studio.DocumentEndpoints;

namespace RayTracer.Studio;

/// <summary>The requests of the timeline.</summary>
internal static class TimelineEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapTimeline(this RouteGroupBuilder api, StudioSession session)
    {
        Timeline timeline = session.Timeline;
        RouteGroupBuilder group = api.MapGroup("/timeline");
        group.MapGet("", async (CancellationToken cancellation) => new TimelineRows(await timeline.WholeRows(cancellation)));
        group.MapGet("/paths", (string? pointer) => timeline.Paths(pointer));
        group.MapPost("/frame", (FrameRequest r) => timeline.Show(r.Frame));
        group.MapPost("/play", (PlayRequest r) =>
        {
            if (r.IsPlaying)
            {
                timeline.Play();
            }
            else
            {
                timeline.Stop();
            }
        });
        group.MapPost("/record", (RecordRequest r) => timeline.Record(r.IsOn));
        group.MapPost("/key", (DocumentRequests.At r) => Revision(timeline.ToggleKey(Needed(r.Pointer, "pointer"))));
        group.MapPost("/move", (KeysRequest r) => Revision(timeline.MoveKeys(Chosen(r), r.Frames, r.Copies, r.Gesture)));
        group.MapPost("/remove", (KeysRequest r) => Revision(timeline.RemoveKeys(Chosen(r))));
        group.MapPost("/ease", (KeysRequest r) => Revision(timeline.EaseKeys(Chosen(r), r.Ease)));
    }

    private static KeyChoice[] Chosen(KeysRequest request) =>
        [.. Needed(request.Keys, "keys").Select(k => new KeyChoice(Needed(k.Keys, "keys"), Needed(k.Numbers, "numbers")))];

    private static IResult Revision(int revision) => Results.Json(new { revision });

    internal sealed record FrameRequest(int? Frame);

    internal sealed record RecordRequest(bool IsOn);

    internal sealed record PlayRequest(bool IsPlaying);

    internal sealed record KeysRequest(KeyChoice[]? Keys, double Frames, bool Copies, Ease Ease, string? Gesture);
}

/// <summary>All that changes with time.</summary>
internal sealed record TimelineRows(IReadOnlyList<TimelineRow> Rows);
