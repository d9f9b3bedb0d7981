-- | The web server of @blackhole explore@, left out of this program.
--
-- This is the back end without a web library. The one on warp exports the same names.
module BlackHole.Explore.Server
  ( serve,
  )
where

import BlackHole.Explore.Service (Service)

-- | 'Nothing': the program is built without a web server.
serve :: Maybe (Maybe Int -> (Int -> Service) -> (Int -> IO ()) -> IO (Either String ()))
serve = Nothing
