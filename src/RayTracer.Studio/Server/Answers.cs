using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>Answers that many requests have in common.</summary>
internal static class Answers
{
    /// <summary>What was asked for is done.</summary>
    public static IResult Done(StudioSession session) => Json(new { revision = session.Document.Revision });

    /// <summary>Data.</summary>
    public static IResult Json<T>(T value) => Results.Json(value, ApiJson.Options);
}
