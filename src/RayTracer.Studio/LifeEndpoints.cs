namespace RayTracer.Studio;

/// <summary>The requests in which a page reports that it closes, and what went wrong in it.</summary>
internal static class LifeEndpoints
{
    private const int LongestLog = 4000;

    /// <summary>Adds the requests.</summary>
    /// <param name="api">The group of requests that they are added to.</param>
    /// <param name="guard">Knows the secret.</param>
    /// <param name="windows">Follows the windows that close.</param>
    /// <param name="errors">Takes the errors of the page.</param>
    public static void MapLife(this RouteGroupBuilder api, LocalGuard guard, WindowWatch windows, TextWriter errors)
    {
        api.MapPost("/bye", async (HttpContext context) =>
        {
            using StreamReader reader = new(context.Request.Body);
            char[] given = new char[guard.TokenLength + 1];
            int length = await reader.ReadBlockAsync(given.AsMemory(), context.RequestAborted);
            if (!guard.IsToken(new(given, 0, length)))
            {
                return Results.StatusCode(StatusCodes.Status401Unauthorized);
            }

            windows.Farewell();
            return Results.NoContent();
        });
        api.MapPost("/log", async (PageLog log) =>
        {
            string text = log.Text.Length > LongestLog ? log.Text[..LongestLog] + " …" : log.Text;

            // The page's text must not pass for the program's, nor command the terminal.
            string printable = new([.. text.Select(c => char.IsControl(c) && c != '\n' ? ' ' : c)]);
            await errors.WriteLineAsync($"page: {printable.ReplaceLineEndings("\n      ")}");
            return Results.NoContent();
        });
    }

    internal sealed record PageLog(string Text);
}
