using RayTracer.Jobs;
using RayTracer.Session;
using RayTracer.Study;

namespace RayTracer.Studio;

/// <summary>Looks inside the picture.</summary>
internal static class InspectionEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapInspection(this RouteGroupBuilder api, StudioSession session)
    {
        api.MapGet("/pick", (float x, float y) => Picking.Selectable(session.Document, session.View.RequireShown(), x, y));
        api.MapGet("/paths", (int x, int y, int? first, int? count) => session.Part<PathInspector>().Inspect(x, y, first ?? 0, count ?? 16));
        api.MapGet("/paths/summary", (int x, int y) => session.Part<PathInspector>().Summarize(x, y));
        api.MapGet("/paths/tree", (int x, int y, int sample, int ray, string tree) => session.Part<TreeWalks>().Walk(x, y, sample, ray, tree));
        api.MapGet("/wireframe", () =>
        {
            ViewportScene shown = session.View.RequireShown();
            return new WireframeView(Wireframe.Of(shown), CameraFrame.Of(shown));
        });
        api.MapGet("/convergence", () => session.View.Loop.Convergence());
        api.MapGet("/times", async (HttpContext context) =>
        {
            ReportTime[] times = await session.Part<ReportTimes>().Measure().WaitAsync(context.RequestAborted);
            return new MeasuredTimes(ReportScene.Machine, ReportTimes.Threads, times);
        });
    }
}

/// <summary>The scene as lines, and the camera that shows it.</summary>
internal sealed record WireframeView(IReadOnlyList<WireShape> Shapes, CameraFrame Camera);

/// <summary>The report's times beside this machine's.</summary>
internal sealed record MeasuredTimes(string Machine, int Threads, IReadOnlyList<ReportTime> Times);
