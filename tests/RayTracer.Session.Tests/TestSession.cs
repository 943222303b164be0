using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>A session whose folders are temporary, and waiting for what it does.</summary>
internal sealed class TestSession : IDisposable
{
    // Only so that a fault is reported instead of waited for: nothing is measured by it.
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);
    private readonly string _folder = Directory.CreateTempSubdirectory("raytracer-studio-test-").FullName;

    public TestSession(TimeProvider? time = null) =>
        Session = new(new(Path.Combine(_folder, "state"), Path.Combine(_folder, "cache"), _folder), ProjectFolder.PathOf("scenes"), time);

    /// <summary>The session.</summary>
    public StudioSession Session { get; }

    /// <summary>Its folder.</summary>
    public string Folder => _folder;

    /// <summary>Opens a text, and waits until it is shown.</summary>
    public async Task<ViewportScene> Open(string json, string? folder = null)
    {
        Session.Document.Open(json, new("test.json", null, folder ?? _folder), isSaved: true);
        DocumentContent content = await Session.Document.WhenBuilt().WaitAsync(Patience);
        Assert.True(content.Load.Scene is not null, string.Join('\n', content.Load.Diagnostics));
        return await Until(() => Session.View.Shown is { } shown && shown.Good.Revision == Session.Document.Revision ? shown : null);
    }

    /// <summary>Opens a scene of the project's, made smaller.</summary>
    public Task<ViewportScene> OpenShipped(string path, int size, int samples)
    {
        string text = File.ReadAllText(ProjectFolder.PathOf("scenes", path));
        JsonText smaller = JsonText.Of(text).Set("/render/width", size).Set("/render/height", size).Set("/render/samplesPerPixel", samples);
        return Open(smaller.Text, Path.GetDirectoryName(ProjectFolder.PathOf("scenes", path)));
    }

    /// <summary>Waits until the picture has its last sample.</summary>
    public Task<RenderStatus> Done() => Until(() => Session.View.Loop.Status is { Status: "done" } done && done.SamplesTotal == Session.View.Shown?.Scene.Render.SamplesPerPixel ? done : null);

    /// <summary>The film's hash, when the picture that is shown has its last sample.</summary>
    public async Task<string> FilmHash()
    {
        using CancellationTokenSource end = new(Patience);
        while (true)
        {
            long version = Session.Changes.Version;
            long picture = Session.View.RequireShown().Picture;
            string? hash = Session.View.Loop.Status.SamplesTotal == 0 ? null
                : await Session.View.Loop.ReadFilm((film, order, samples) => order.Picture == picture && samples == order.Samples ? film.ComputeHash() : null);
            if (hash is not null)
            {
                return hash;
            }

            Assert.True(await Session.Changes.WaitBeyond(version, end.Token), "The picture did not come to its end.");
        }
    }

    /// <summary>Waits for a frame.</summary>
    public async Task<FrameLease> Frame(long after = 0, Func<FrameInfo, bool>? wanted = null)
    {
        using CancellationTokenSource end = new(Patience);
        while (true)
        {
            Assert.True(await Session.View.Frames.Wait(after, end.Token), "No frame came.");
            FrameLease? frame = Session.View.Frames.Borrow();
            if (frame is null)
            {
                // It was taken down again: it was of a document that is no longer open.
                continue;
            }

            if (wanted is null || wanted(frame.Info))
            {
                return frame;
            }

            after = frame.Version;
            frame.Dispose();
        }
    }

    /// <summary>Waits until something is there.</summary>
    public async Task<T> Until<T>(Func<T?> find)
        where T : class
    {
        using CancellationTokenSource end = new(Patience);
        while (true)
        {
            long version = Session.Changes.Version;
            if (find() is { } found)
            {
                return found;
            }

            Assert.True(await Session.Changes.WaitBeyond(version, end.Token), "What was waited for did not come.");
        }
    }

    public void Dispose()
    {
        Session.Dispose();
        Directory.Delete(_folder, recursive: true);
    }
}
