namespace RayTracer.Studio;

/// <summary>What the page may load and do (Content Security Policy): nothing but what comes from this server.</summary>
internal static class ContentPolicy
{
    /// <summary>The header's value. Style sheets that the page makes itself are constructed ones, which need no permission.</summary>
    public const string Header = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; font-src 'self'; "
        + "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}
