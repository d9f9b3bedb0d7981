-- | The options of @blackhole explore@.
module BlackHole.Cli.Explore.Options
  ( ExploreOptions (..),
    exploreOptions,
  )
where

import BlackHole.Cli.Read
import BlackHole.Cli.RunOptions (threadsOption)
import BlackHole.Cli.SceneOptions
import Options.Applicative

-- | The options of @blackhole explore@.
data ExploreOptions = ExploreOptions
  { exploreScene :: !SceneOptions,
    explorePort :: !(Maybe Int),
    -- | Do not open a browser.
    exploreNoOpen :: !Bool,
    -- | Go on when the last page is closed.
    exploreKeep :: !Bool,
    exploreThreads :: !(Maybe Int)
  }
  deriving (Eq, Show)

-- | Their parser.
exploreOptions :: Parser ExploreOptions
exploreOptions =
  ExploreOptions
    <$> sceneOptions
    <*> setting
      ( option
          wholeNumber
          ( long "port" <> metavar "N"
              <> help "Port of the loopback interface (default: a free one)"
          )
      )
    <*> toggle (long "no-open" <> help "Only print the address instead of opening it in a browser")
    <*> toggle
      ( long "keep"
          <> help "Keep running when the last page is closed (default: end half a minute later)"
      )
    <*> threadsOption
