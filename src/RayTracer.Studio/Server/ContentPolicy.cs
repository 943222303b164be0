namespace RayTracer.Studio;

/// <summary>What the page may load and do (Content Security Policy): nothing but what comes from this server.</summary>
internal static class ContentPolicy
{
    /// <summary>The header's value.</summary>
    /// <param name="styleNonce">What the page's scripts may mark style sheets of their own with; null for none.</param>
    public static string Header(string? styleNonce)
    {
        string ownStyles = styleNonce is null ? "" : $" 'nonce-{styleNonce}'";
        return "default-src 'none'; script-src 'self'; style-src 'self'" + ownStyles
            + "; img-src 'self' blob: data:; connect-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    }
}
