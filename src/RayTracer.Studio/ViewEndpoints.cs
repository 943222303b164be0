using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Session;
using static RayTracer.Studio.DocumentEndpoints;

namespace RayTracer.Studio;

/// <summary>The requests that change the view: camera, exposure, rendering, snapshots.</summary>
internal static class ViewEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapView(this RouteGroupBuilder api, StudioSession session)
    {
        RouteGroupBuilder view = api.MapGroup("/view");
        view.MapPost("/camera", (CameraMove move) => session.Camera.Move(move));
        view.MapPost("/camera/write", () => Results.Json(new { revision = session.Camera.Write() }));
        view.MapPost("/bookmark/add", (BookmarkRequest request) => session.Bookmarks.Add(request.Name));
        view.MapPost("/bookmark/show", (BookmarkRequest request) => session.Camera.Look(session.Bookmarks.Pose(request.Id)));
        view.MapPost("/bookmark/remove", (BookmarkRequest request) => session.Bookmarks.Remove(request.Id));
        view.MapPost("/focus", (PixelRequest at) => Results.Json(new { distance = session.Camera.Focus(at.X, at.Y), revision = session.Document.Revision }));
        view.MapPost("/tone", (ToneRequest tone) =>
        {
            Tone before = session.View.Tone;
            Exposure exposure = tone.Rule is { } rule ? new(rule == ExposureRule.Stops ? session.View.Stops : 0, rule) : before.Exposure;
            session.View.Tone = new(tone.Exposure ?? exposure, tone.ToneMap ?? before.ToneMap);
        });
        view.MapPost("/render", (RenderRequest request) => session.View.Change(request.Apply, restart: request.Action == "restart"));
        view.MapPost("/snapshot", () => session.Snapshots.Capture());
        view.MapGet("/snapshot", (int id) => Results.Bytes(session.Snapshots.Png(id), "image/png"));
        view.MapPost("/snapshot/rename", (SnapshotRequest request) => session.Snapshots.Rename(request.Id, request.Name));
        view.MapGet("/compare", (int image, int reference) => session.Snapshots.Compare(image, reference));
        view.MapGet("/compare/picture", (int image, int reference, string map) => Results.Bytes(session.Snapshots.Png(image, reference, MapOf(map)), "image/png"));
        view.MapGet("/pixels", async (int x, int y, int width, int height) =>
        {
            try
            {
                return await session.View.Loop.Pixels(new(x, y, width, height));
            }
            catch (SessionException)
            {
                // Since the pointer was there, the picture has become another, or has gone.
                return [];
            }
        });
        view.MapPost("/lights/mix", (MixRequest request) => session.Mixer.Mix(request.Factors));
        view.MapPost("/lights/write", () => Results.Json(new { revision = session.Mixer.Write() }));
        view.MapGet("/mask", (string pointer, int? step) => Picking.Mask(session.View.RequireShown(), pointer, step ?? 1));
        view.MapPost("/gizmo", (HandlesRequest request) =>
        {
            (ViewportScene shown, string pointer) = (session.View.RequireShown(), Needed(request.Pointer, "pointer"));
            return (session.Document.IsLocked(pointer) ? null : Gizmo.Find(shown, pointer))?.Handles(CameraFrame.Of(shown), request.Kind, request.Length) ?? new(request.Kind, default, null, []);
        });
        view.MapGet("/lights", () => session.View.Shown is { Camera.Projection.IsStraight: true } shown ? LightBody.Of(shown) : []);
        view.MapPost("/light/drag", (LightDrag drag) => session.LightHandles.Drag(drag with { Pointer = Needed(drag.Pointer, "pointer") }));
        view.MapPost("/hide", (MarkRequest request) => session.Document.Hide(Needed(request.Pointers, "pointers"), request.IsMarked));
        view.MapPost("/lock", (MarkRequest request) => session.Document.Lock(Needed(request.Pointers, "pointers"), request.IsMarked));
        view.MapPost("/drag", (HandleDrag way) => session.Handles.Drag(way with { Pointer = Needed(way.Pointer, "pointer") }));
    }

    private static ComparisonMap MapOf(string name) =>
        Enum.TryParse(name, ignoreCase: true, out ComparisonMap map) && Enum.IsDefined(map) ? map : throw new SessionException($"There is no comparison \"{name}\": it may be difference or flip.");

    internal sealed record PixelRequest(float X, float Y);

    internal sealed record MixRequest(Dictionary<string, float[]>? Factors);

    internal sealed record SnapshotRequest(int Id, string? Name);

    internal sealed record MarkRequest(string[]? Pointers, bool IsMarked);

    internal sealed record BookmarkRequest(int Id, string? Name);

    internal sealed record HandlesRequest(string? Pointer, GizmoKind Kind, float Length);

    internal sealed record ToneRequest(float? Exposure, ExposureRule? Rule, ToneMap? ToneMap);

    /// <summary>The changes of the settings; what is null stays.</summary>
    internal sealed record RenderRequest(string? Action, int? Samples, int? Threads, RenderQuality? Quality, int[]? Region, string? Map, bool? FiltersMotion, string? Edition)
    {
        public ViewSettings Apply(ViewSettings settings) => (Edition is null ? settings : settings.WithEdition(Edition)) with
        {
            Mode = Action switch
            {
                null => settings.Mode,
                "stop" => RenderMode.Stopped,
                "pause" => RenderMode.Paused,
                "continue" or "restart" => RenderMode.Running,
                _ => throw new SessionException($"There is no action \"{Action}\": it may be stop, pause, continue or restart."),
            },
            Samples = Quality is { } quality ? (int)quality : Samples switch { null => settings.Samples, 0 => null, _ => Samples },
            Threads = Threads ?? settings.Threads,
            FiltersMotion = FiltersMotion ?? settings.FiltersMotion,
            Map = Map is null ? settings.Map : ViewMap.Named(Map),
            Region = Region switch
            {
                null => settings.Region,
                [] => null,
                [var x, var y, var width, var height] => new Tile(x, y, width, height),
                _ => throw new SessionException("A region is [x, y, width, height]."),
            },
        };
    }
}
