using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>Films that took long are there after a session's end, however it came.</summary>
public sealed class FilmKeeperTests : IDisposable
{
    private const string Scene = """
        { "camera": { "position": [0, 0, 5] }, "background": "white", "shapes": [{ "type": "sphere", "center": [0, 0, 0] }],
          "render": { "integrator": "report", "width": 16, "height": 16, "samplesPerPixel": 1048576 } }
        """;

    private readonly SessionFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task An_unfinished_picture_is_offered_by_the_next_session_and_resumed_with_its_samples()
    {
        int samples;
        using (StudioSession first = await Rendering())
        {
            samples = first.View.Loop.Status.Samples;
        }

        using StudioSession second = new(_folder.User);
        RecoveryEntry entry = Assert.Single(second.Recovery.Entries);
        Assert.Equal(("long", true), (entry.Name, entry.IsFilm));
        second.Files.OpenRecovered(entry.Id);
        await Until(() => second.View.Shown?.Start is not null && second.View.Loop.Status.Samples >= samples);
        Assert.Null(second.Document.Place.Path);
        Assert.Empty(second.Recovery.Entries);
        Assert.Equal(Scene.Trim(), second.Document.Text.Trim());
    }

    [Fact]
    public async Task A_living_sessions_film_is_not_offered_and_one_that_was_discarded_is_gone()
    {
        using (StudioSession first = await Rendering())
        {
            await first.Films.Keep();
            Assert.Single(Directory.GetFiles(_folder.User.RecoveredFilms, "*.rtfilm", SearchOption.AllDirectories));
            using StudioSession beside = new(_folder.User);
            Assert.Empty(beside.Recovery.Entries);
        }

        using StudioSession second = new(_folder.User);
        second.Recovery.Discard(Assert.Single(second.Recovery.Entries).Id);
        Assert.Empty(second.Recovery.Entries);
        Assert.Empty(Directory.GetDirectories(_folder.User.RecoveredFilms));
    }

    [Fact]
    public async Task A_film_is_kept_soon_after_it_is_worth_it_and_then_seldom()
    {
        FakeTime time = new();
        using StudioSession session = await Rendering(time: time);
        Assert.True(session.Films.IsDue);
        time.Pass(TimeSpan.FromSeconds(10));
        await Until(() => Directory.GetFiles(_folder.User.RecoveredFilms, "*.rtfilm", SearchOption.AllDirectories).Length == 1);

        // One at a time: afterwards, the other is done.
        await session.Films.Keep();
        int samples = session.View.Loop.Status.Samples;
        await Until(() => session.View.Loop.Status.Samples > samples);
        Assert.False(session.Films.IsDue);
    }

    [Fact]
    public async Task What_took_no_time_is_not_kept()
    {
        using (await Rendering(worth: 1e6))
        {
        }

        using StudioSession second = new(_folder.User);
        Assert.Empty(second.Recovery.Entries);
    }

    private async Task<StudioSession> Rendering(double worth = 0, TimeProvider? time = null)
    {
        StudioSession session = new(_folder.User);
        session.Films = new(session.Document, session.View, session.Pictures, _folder.User, time ?? TimeProvider.System, worth);
        session.Document.Open(Scene, new("long.json", null, _folder.FullName), isSaved: true);
        await Until(() => session.View.Shown?.Good.Revision == session.Document.Revision && session.View.Loop.Status is { Samples: >= 4, SamplesTotal: 1048576 });
        return session;
    }

    private static async Task Until(Func<bool> isSo)
    {
        for (int i = 0; i < 3000 && !isSo(); i++)
        {
            await Task.Delay(10);
        }

        Assert.True(isSo());
    }
}
