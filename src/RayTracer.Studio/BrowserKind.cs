namespace RayTracer.Studio;

/// <summary>What the page is opened in.</summary>
internal enum BrowserKind
{
    /// <summary>A window of its own, of Chromium, Chrome or Edge, where there is one; else the default browser.</summary>
    App,

    /// <summary>The default browser.</summary>
    Default,
}
