using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>The documentation: its pages, their pictures, and a search over them.</summary>
internal static class HelpEndpoints
{
    /// <summary>Adds the requests.</summary>
    public static void MapHelp(this RouteGroupBuilder api, StudioSession session)
    {
        api.MapGet("/help", () => new HelpIndex(session.Part<HelpPages>().Pages));
        api.MapGet("/help/page", (string id) => session.Part<HelpPages>().Page(id));
        api.MapGet("/help/search", (string words) => new HelpFindings(session.Part<HelpPages>().Find(words)));
        api.MapGet("/help/picture", (string path) =>
            Results.Stream(HelpPages.Picture(path), path.EndsWith(".svg", StringComparison.Ordinal) ? "image/svg+xml" : "image/jpeg"));
    }
}

/// <summary>All pages.</summary>
internal sealed record HelpIndex(IReadOnlyList<HelpEntry> Pages);

/// <summary>What a search has found.</summary>
internal sealed record HelpFindings(IReadOnlyList<HelpFinding> Findings);
