using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>The browser that all walks share: Chromium or Chrome as it is installed; without one, they are skipped with the reason.</summary>
public sealed class ChromiumBrowser : IAsyncLifetime
{
    private IPlaywright? _playwright;

    /// <summary>The browser; null where there is none.</summary>
    public IBrowser? Instance { get; private set; }

    /// <summary>Why there is none.</summary>
    public string WhyNot { get; private set; } = "";

    /// <inheritdoc/>
    public async Task InitializeAsync()
    {
        string? program = InstalledBrowser.Find();
        if (program is null)
        {
            WhyNot = InstalledBrowser.WhyNot;
            return;
        }

        // What is waited for comes, however busy the machine is.
        SetDefaultExpectTimeout(60_000);
        _playwright = await Playwright.CreateAsync();

        // Processes of root, as in containers, have no sandbox.
        Instance = await _playwright.Chromium.LaunchAsync(new() { ExecutablePath = program, Args = ["--no-sandbox", "--disable-dev-shm-usage"] });
    }

    /// <inheritdoc/>
    public async Task DisposeAsync()
    {
        if (Instance is not null)
        {
            await Instance.CloseAsync();
        }

        _playwright?.Dispose();
    }
}

/// <summary>Tests that use the browser run one after the other, as they would make each other slow; beside them, others use the time in which they wait.</summary>
[CollectionDefinition(Name)]
public sealed class BrowserCollection : ICollectionFixture<ChromiumBrowser>
{
    /// <summary>The collection's name.</summary>
    public const string Name = "browser";
}
